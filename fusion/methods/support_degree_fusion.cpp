#include "fusion/methods/support_degree_fusion.hpp"

#include <algorithm>
#include <cmath>

#include "core/frames.hpp"
#include "core/parameter_check.hpp"

namespace lookout::fusion {
namespace {

/// Support that the repaired weights leave to every tracklet. docs/fusion.md.
constexpr double kLeastSupport = 0.05;

double median(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// Gives those without a line the mean support of those with one.
void fill_in_standing(const std::vector<bool>& has_line, std::vector<double>& support) {
  double sum = 0.0;
  int lines = 0;
  for (std::size_t i = 0; i < support.size(); ++i) {
    if (!has_line[i]) continue;
    sum += support[i];
    ++lines;
  }
  for (std::size_t i = 0; i < support.size(); ++i) {
    if (!has_line[i]) support[i] = lines > 0 ? sum / lines : 1.0;
  }
}

/// Squared distance of a tracklet from the global track [m^2].
double squared_residual(const TrackGroup& group, const Contribution& contribution) {
  // Signed rho about the predicted position and the residual along the line: together the offset itself.
  const Eigen::Vector2d offset = contribution.current.head<2>() - group.predicted.head<2>();
  const Eigen::Vector2d step = contribution.track->displacement();
  const Eigen::Vector2d global_step = group.predicted.head<2>() - group.previous.head<2>();
  if (step.squaredNorm() == 0.0 || global_step.squaredNorm() == 0.0) return offset.squaredNorm();
  const double turn = std::atan2(step.y(), step.x()) - std::atan2(global_step.y(), global_step.x());
  const double swing = step.norm() * core::wrap_to_pi(turn);
  return offset.squaredNorm() + swing * swing;
}

}  // namespace

SupportDegreeFusion::SupportDegreeFusion(const SupportDegreeParams& params,
                                         const LearnedGeometryParams& errors)
    : ScalarWeightFusion(errors), params_(params) {
  core::require_positive("length_unit", params.length_unit);
}

void SupportDegreeFusion::append_points(const TrackGroup& group, Points& points) const {
  const Eigen::Vector2d& origin = params_.p_earth_origin;
  points.push_back(hough_point(group.previous.head<2>(), group.predicted.head<2>(), origin));  // Eq. (15)
  for (const Contribution& contribution : group.contributions) {
    const Eigen::Vector2d newer = contribution.track->newest().state.head<2>();
    points.push_back(hough_point(newer - contribution.track->displacement(), newer, origin));  // Eq. (3)-(5)
  }
}

double SupportDegreeFusion::largest_pair(const Points& points) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      if (points[i] && points[j])
        largest = std::max(largest, hough_distance(*points[i], *points[j], params_.length_unit));
    }
  }
  return largest;
}

void SupportDegreeFusion::look_at_all(std::span<const TrackGroup> groups) {
  if (params_.reading != SupportReading::all) return;
  points_.clear();
  for (const TrackGroup& group : groups) append_points(group, points_);
  largest_of_scan_ = largest_pair(points_);
}

void SupportDegreeFusion::support(const TrackGroup& group, std::vector<double>& support) {
  points_.clear();
  append_points(group, points_);
  if (!points_.front()) return;  // The global track stands: nothing to compare with, equal weights.
  double largest = params_.reading == SupportReading::all ? largest_of_scan_ : 0.0;
  std::vector<bool> has_line(support.size());
  for (std::size_t i = 0; i < support.size(); ++i) {
    has_line[i] = points_[i + 1].has_value();
    support[i] = has_line[i] ? hough_distance(*points_[i + 1], *points_.front(), params_.length_unit) : 0.0;
    largest = std::max(largest, support[i]);  // Eq. (14)
  }
  if (params_.reading == SupportReading::any) largest = largest_pair(points_);
  if (largest == 0.0) return std::fill(support.begin(), support.end(), 1.0);
  for (double& entry : support) entry = 1.0 - entry / largest;  // Eq. (17)
  fill_in_standing(has_line, support);
}

void SupportDegreeFixed::support(const TrackGroup& group, std::vector<double>& support) {
  for (std::size_t i = 0; i < support.size(); ++i)
    support[i] = squared_residual(group, group.contributions[i]);
  sorted_ = support;
  const double middle = std::max(median(sorted_), std::numeric_limits<double>::min());
  for (double& entry : support) entry = 1.0 / (1.0 + entry / middle) + kLeastSupport;
}

}  // namespace lookout::fusion
