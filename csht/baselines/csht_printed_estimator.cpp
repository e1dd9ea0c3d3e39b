#include "csht/baselines/csht_printed_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parameter_check.hpp"
#include "csht/candidate.hpp"
#include "csht/elements.hpp"

namespace lookout::csht {
namespace {

/// The variance of what lies anywhere in a cell of side `step`, [step]^2.
double cell_variance(double step) {
  constexpr double kUniform = 12.0;  // Width squared over variance of a uniform distribution.
  return step * step / kUniform;
}

/// The paper's votes: a whole one in the cell that holds the intercept, every line sample for itself.
VoteParams plain_votes() {
  VoteParams votes;
  votes.fuzzy = false;
  votes.one_vote_a_scan = false;
  return votes;
}

HoughSpace make_space(const CshtPrintedParams& params, const core::SonarParams& sonar) {
  const double window = (params.window_scans - 1) * sonar.scan_period;
  const HoughGrid grid{params.velocity_step, params.intercept_step, sonar.max_speed,
                       2.0 * sonar.max_range + 4.0 * sonar.max_speed * window};
  return {grid, plain_votes(), sonar.range_sigma, sonar.range_sigma};
}

const CshtPrintedParams& validated(const CshtPrintedParams& params) {
  core::require(params.window_scans >= 3 && params.window_scans <= kMaxWindowScans,
                "window_scans must be 3 to 100", params.window_scans);
  params.threshold.validate();
  core::require(params.first_classes >= 1, "first_classes must be > 0", params.first_classes);
  return params;
}

}  // namespace

CshtPrintedEstimator::CshtPrintedEstimator(const CshtPrintedParams& params, const core::SonarParams& sonar)
    : params_(validated(params)),
      window_(params.window_scans, sonar, 0.0),
      north_votes_(make_space(params, sonar)),
      east_votes_(make_space(params, sonar)),
      isodata_(params.isodata) {}

std::span<const core::MotionElement> CshtPrintedEstimator::update(const core::PosedScan& scan) {
  window_.add(scan);
  north_votes_.remove(window_.forgotten_lines(0));
  north_votes_.add(window_.newest_lines(0));
  elements_.clear();
  if (static_cast<int>(window_.scans().size()) < params_.first_estimate_scans) return elements_;
  keep_cells(north_votes_, 0);
  spread_first_classes();
  classes_.clear();
  for (const auto& centre : isodata_.cluster(points_, first_))
    classes_.push_back({static_cast<double>(centre.x), static_cast<double>(centre.y)});
  correlate();
  return elements_;
}

// [Yan2018] Eq. (17)-(20); intercepts at the start of the window.
void CshtPrintedEstimator::keep_cells(const HoughSpace& space, int axis) {
  const auto& first_scan = window_.scans().front();
  const auto& pose = first_scan.T_earth_sonar;
  const double threshold = primary_threshold(params_.threshold, space.statistics());
  space.cells_above(threshold, first_scan.time, axis == 0 ? pose.north : pose.east, cells_);
  points_.clear();
  for (const auto& cell : cells_)
    points_.push_back({static_cast<float>(cell.velocity), static_cast<float>(cell.intercept)},
                      static_cast<float>(cell.votes));
  points_.pad();
}

/// Evenly from the smallest features to the largest: the paper does not say where the classes start.
void CshtPrintedEstimator::spread_first_classes() {
  first_.clear();
  if (cells_.empty()) return;
  auto [low_v, high_v] = std::minmax_element(
      cells_.begin(), cells_.end(), [](const auto& a, const auto& b) { return a.velocity < b.velocity; });
  auto [low_n, high_n] = std::minmax_element(
      cells_.begin(), cells_.end(), [](const auto& a, const auto& b) { return a.intercept < b.intercept; });
  for (int k = 0; k < params_.first_classes; ++k) {
    const double share = (k + 0.5) / params_.first_classes;
    first_.push_back({static_cast<float>(std::lerp(low_v->velocity, high_v->velocity, share)),
                      static_cast<float>(std::lerp(low_n->intercept, high_n->intercept, share))});
  }
}

// [Yan2018] Eq. (40), (41): every detection to the class whose current north position is nearest.
void CshtPrintedEstimator::correlate() {
  const double start = window_.scans().front().time, now = window_.scans().back().time;
  const auto north = window_.lines(0), east = window_.lines(1);
  class_of_.assign(north.size(), 0);
  for (std::size_t k = 0; k < north.size(); ++k) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < classes_.size(); ++c) {
      const double time = params_.own_time ? north[k].time : now;
      const double expected = classes_[c].intercept + classes_[c].velocity * (time - start);
      if (std::abs(north[k].position - expected) >= nearest) continue;
      nearest = std::abs(north[k].position - expected);
      class_of_[k] = static_cast<int>(c);
    }
  }
  for (std::size_t c = 0; c < classes_.size(); ++c) {
    east_samples_.clear();
    for (std::size_t k = 0; k < east.size(); ++k)
      if (class_of_[k] == static_cast<int>(c)) east_samples_.push_back(east[k]);
    if (const auto line = single_line()) report(classes_[c], *line);
  }
}

/// The clustering statistic with one class: all memberships are 1, and Eq. (23) is the weighted mean of the
/// cells above the primary threshold.
std::optional<Line> CshtPrintedEstimator::single_line() {
  if (east_samples_.empty()) return std::nullopt;
  east_votes_.clear();
  east_votes_.add(east_samples_);
  keep_cells(east_votes_, 1);
  if (cells_.empty()) return std::nullopt;
  first_.assign(1, points_.mean());
  const auto centres = isodata_.cluster(points_, first_);
  return Line{static_cast<double>(centres.front().x), static_cast<double>(centres.front().y)};
}

/// The covariance is that of a cell and of the classes' width in the vote matrix: the method has no other.
void CshtPrintedEstimator::report(const Line& north, const Line& east) {
  const HoughGrid& grid = north_votes_.grid();
  const double sigma = window_.sonar().range_sigma;
  const double window = window_.scans().back().time - window_.scans().front().time;
  Candidate target;
  target.state << north.intercept, east.intercept, north.velocity, east.velocity;
  const double position = cell_variance(grid.intercept_step) + sigma * sigma;
  const double velocity = cell_variance(grid.velocity_step) + sigma * sigma / (window * window);
  target.covariance.diagonal() << position, position, velocity, velocity;
  target.support = static_cast<int>(east_samples_.size());
  elements_.push_back(to_element(target, window_, window_.scans().front().time));
}

}  // namespace lookout::csht
