#include "fusion/learned_geometry.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::fusion {
namespace {

/// Added to the information, relative to its trace, so that sensors in line with the target leave it regular.
constexpr double kRegularisation = 1e-6;
/// Nearest that a target counts as to a sensor [m], so that the bearing keeps a meaning.
constexpr double kLeastRange = 1.0;

/// Expected square of a node's own error where its variance is `own`, age adds an independent error of
/// variance `aging`, and the sum of the two has the expected square `total`. Never negative, unlike
/// total - aging.
double own_share(double own, double aging, double total) {
  const double gain = own / (own + aging);
  return gain * gain * total + gain * aging;
}

}  // namespace

LearnedGeometry::LearnedGeometry(const LearnedGeometryParams& params) : params_(params) {
  core::require_positive("range_sigma", params.range_sigma);
  core::require_positive("bearing_sigma", params.bearing_sigma);
  core::require(params.window_updates >= 1, "window_updates must be >= 1", params.window_updates);
  core::require(params.iterations >= 1, "iterations must be >= 1", params.iterations);
  core::require(params.pseudo_samples >= 0.0, "pseudo_samples must be >= 0", params.pseudo_samples);
  core::require(params.velocity_sigma >= 0.0, "velocity_sigma must be >= 0", params.velocity_sigma);
  core::require_positive("least_share", params.least_share);
  least_ = {std::pow(params.least_share * params.range_sigma, 2),
            std::pow(params.least_share * params.bearing_sigma, 2)};
  reset();
}

void LearnedGeometry::reset() {
  index_.clear();
  quality_.clear();
  window_.assign(static_cast<std::size_t>(params_.window_updates), Update{});
  newest_ = 0;
}

LearnedGeometry::NodeQuality LearnedGeometry::quality(std::int32_t node_id) const {
  const auto found = index_.find(node_id);
  if (found != index_.end()) return quality_[found->second];
  return {params_.range_sigma * params_.range_sigma, params_.bearing_sigma * params_.bearing_sigma};
}

std::span<const FusedState> LearnedGeometry::fuse(std::span<const TrackGroup> groups) {
  remember(groups);
  for (int k = 0; k < params_.iterations; ++k) iterate();
  fused_.clear();
  const Update& update = window_[newest_];
  std::size_t begin = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::span<const View> views(update.views.data() + begin, update.ends[g] - begin);
    fused_.push_back(fuse_group(groups[g], views));
    begin = update.ends[g];
  }
  return fused_;
}

std::size_t LearnedGeometry::index_of(std::int32_t node_id) {
  const auto [entry, is_new] = index_.try_emplace(node_id, quality_.size());
  if (is_new)
    quality_.push_back(
        {params_.range_sigma * params_.range_sigma, params_.bearing_sigma * params_.bearing_sigma});
  return entry->second;
}

LearnedGeometry::View LearnedGeometry::view_of(const TrackGroup& group, const Contribution& contribution) {
  const LocalEstimate& estimate = contribution.track->newest();
  const Eigen::Vector2d sight = contribution.current.head<2>() - estimate.p_earth_node;
  const double range = sight.norm();
  const Eigen::Vector2d direction = range > 0.0 ? (sight / range).eval() : Eigen::Vector2d::UnitX();
  const double drift = params_.velocity_sigma * contribution.track->age(group.utime);
  const double squared_range = std::max(range, kLeastRange) * std::max(range, kLeastRange);
  return {contribution.current.head<2>(), direction, squared_range, drift * drift,
          index_of(estimate.node_id)};
}

void LearnedGeometry::remember(std::span<const TrackGroup> groups) {
  newest_ = (newest_ + 1) % window_.size();
  Update& update = window_[newest_];
  update.views.clear();
  update.ends.clear();
  for (const TrackGroup& group : groups) {
    for (const Contribution& contribution : group.contributions)
      update.views.push_back(view_of(group, contribution));
    update.ends.push_back(update.views.size());
  }
}

Eigen::Matrix2d LearnedGeometry::information(const View& view) const {
  // I = u u'/s_r + v v'/(s_b r^2) = 1/across + (1/along - 1/across) u u'.
  const NodeQuality& quality = quality_[view.node];
  const double along = 1.0 / (quality.range_variance + view.aging);
  const double across = 1.0 / (quality.bearing_variance * view.squared_range + view.aging);
  const Eigen::Vector2d& u = view.line_of_sight;
  Eigen::Matrix2d result = (along - across) * u * u.transpose();
  result(0, 0) += across;
  result(1, 1) += across;
  return result;
}

LearnedGeometry::Fix LearnedGeometry::fix(std::span<const View> views) const {
  // Relative to one of them, so that the regularisation pulls to the target and not to the earth's origin.
  const Eigen::Vector2d anchor = views.front().position;
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
  for (const View& view : views) {
    const Eigen::Matrix2d own = information(view);
    sum += own;
    weighted += own * (view.position - anchor);
  }
  sum += kRegularisation * sum.trace() * Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d covariance = sum.inverse();
  return {anchor + covariance * weighted, covariance};
}

void LearnedGeometry::iterate() {
  moments_.assign(quality_.size(), Moments{});
  for (const Update& update : window_) {
    std::size_t begin = 0;
    for (std::size_t end : update.ends) {
      // A target that one node alone sees says nothing of that node's error.
      if (end - begin >= 2) add_residuals({update.views.data() + begin, end - begin});
      begin = end;
    }
  }
  maximise();
}

void LearnedGeometry::add_residuals(std::span<const View> views) {
  const Fix fused = fix(views);
  for (const View& view : views) {
    const Eigen::Vector2d& u = view.line_of_sight;
    const Eigen::Vector2d v(-u.y(), u.x());
    const Eigen::Vector2d residual = view.position - fused.position;
    const double along = u.dot(residual), across = v.dot(residual);
    Moments& moments = moments_[view.node];
    const NodeQuality& quality = quality_[view.node];
    const double range_squared = view.squared_range;
    moments.along +=
        own_share(quality.range_variance, view.aging, along * along + u.dot(fused.covariance * u));
    moments.across += own_share(quality.bearing_variance * range_squared, view.aging,
                                across * across + v.dot(fused.covariance * v)) /
                      range_squared;
    moments.count += 1.0;
  }
}

double LearnedGeometry::median_of(double Moments::*part) {
  sorted_.clear();
  for (const Moments& moments : moments_) {
    if (moments.count > 0.0) sorted_.push_back(moments.*part / moments.count);
  }
  std::sort(sorted_.begin(), sorted_.end());
  const std::size_t half = sorted_.size() / 2;
  return sorted_.size() % 2 == 1 ? sorted_[half] : 0.5 * (sorted_[half - 1] + sorted_[half]);
}

void LearnedGeometry::maximise() {
  const bool heard =
      std::any_of(moments_.begin(), moments_.end(), [](const Moments& m) { return m.count > 0.0; });
  if (!heard) return;
  const double extra = params_.pseudo_samples;
  const double along = median_of(&Moments::along), across = median_of(&Moments::across);
  for (std::size_t node = 0; node < quality_.size(); ++node) {
    const Moments& moments = moments_[node];
    if (moments.count + extra == 0.0) continue;
    const NodeQuality learned{(moments.along + extra * along) / (moments.count + extra),
                              (moments.across + extra * across) / (moments.count + extra)};
    quality_[node] = {std::max(least_.range_variance, learned.range_variance),
                      std::max(least_.bearing_variance, learned.bearing_variance)};
  }
}

FusedState LearnedGeometry::fuse_group(const TrackGroup& group, std::span<const View> views) const {
  const Fix fused = fix(views);
  const Eigen::Vector2d anchor = group.contributions.front().current.tail<2>();
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < views.size(); ++i)
    weighted += information(views[i]) * (group.contributions[i].current.tail<2>() - anchor);
  FusedState result;
  result.state << fused.position, anchor + fused.covariance * weighted;
  result.covariance.topLeftCorner<2, 2>() = fused.covariance;
  const double velocity_variance = params_.velocity_sigma * params_.velocity_sigma;
  result.covariance.bottomRightCorner<2, 2>().diagonal().setConstant(velocity_variance);
  return result;
}

}  // namespace lookout::fusion
