#include "fusion/learned_geometry.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"
#include "fusion/methods/covariance_fusion.hpp"

namespace lookout::fusion {
namespace {

/// Added to the information, relative to its trace, so that sensors in line with the target leave it regular.
constexpr double kRegularisation = 1e-6;
/// Nearest that a target counts as to a sensor [m], so that the bearing keeps a meaning.
constexpr double kLeastRange = 1.0;
/// Least error of a velocity with which learning begins [m/s], so that no weight is infinite.
constexpr double kLeastRate = 1e-3;

/// Expected square of a node's own error where its variance is `own`, age adds an independent error of
/// variance `aging`, and the sum of the two has the expected square `total`. Never negative, unlike
/// total - aging.
double own_share(double own, double aging, double total) {
  const double gain = own / (own + aging);
  return gain * gain * total + gain * aging;
}

bool is_alone_with_covariance(const TrackGroup& group) {
  return group.contributions.size() == 1 && group.contributions.front().track->newest().covariance;
}

}  // namespace

LearnedGeometry::LearnedGeometry(const LearnedGeometryParams& params) : params_(params) {
  core::require_positive("range_sigma", params.range_sigma);
  core::require_positive("bearing_sigma", params.bearing_sigma);
  core::require(params.window_updates >= 1, "window_updates must be >= 1", params.window_updates);
  core::require(params.iterations >= 1, "iterations must be >= 1", params.iterations);
  core::require_not_negative("pseudo_samples", params.pseudo_samples);
  core::require_not_negative("velocity_sigma", params.velocity_sigma);
  core::require_not_negative("process_noise", params.process_noise);
  core::require_positive("least_share", params.least_share);
  const NodeQuality first = first_quality();
  const double share = params.least_share * params.least_share;
  least_ = {share * first.range_variance, share * first.bearing_variance, share * first.range_rate_variance,
            share * first.bearing_rate_variance};
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
  return found == index_.end() ? first_quality() : quality_[found->second];
}

/// Where learning begins; velocities err in the same proportion along and across as positions.
LearnedGeometry::NodeQuality LearnedGeometry::first_quality() const {
  const double range = params_.range_sigma, bearing = params_.bearing_sigma;
  const double rate = std::max(params_.velocity_sigma, kLeastRate);
  return {range * range, bearing * bearing, rate * rate, std::pow(bearing * rate / range, 2)};
}

std::span<const FusedState> LearnedGeometry::fuse(std::span<const TrackGroup> groups) {
  learn(groups);
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

void LearnedGeometry::learn(std::span<const TrackGroup> groups) {
  remember(groups);
  for (int k = 0; k < params_.iterations; ++k) iterate();
}

std::size_t LearnedGeometry::index_of(std::int32_t node_id) {
  const auto [entry, is_new] = index_.try_emplace(node_id, quality_.size());
  if (is_new) quality_.push_back(first_quality());
  return entry->second;
}

LearnedGeometry::View LearnedGeometry::view_of(const TrackGroup& group, const Contribution& contribution,
                                               std::size_t node) const {
  const LocalEstimate& estimate = contribution.track->newest();
  const Eigen::Vector2d sight = contribution.current.head<2>() - estimate.p_earth_node;
  const double range = sight.norm();
  const Eigen::Vector2d direction = range > 0.0 ? (sight / range).eval() : Eigen::Vector2d::UnitX();
  const double drift = params_.velocity_sigma * contribution.track->age(group.utime);
  const double squared_range = std::max(range, kLeastRange) * std::max(range, kLeastRange);
  return {contribution.current.head<2>(),
          contribution.current.tail<2>(),
          direction,
          squared_range,
          drift * drift,
          node};
}

void LearnedGeometry::remember(std::span<const TrackGroup> groups) {
  newest_ = (newest_ + 1) % window_.size();
  Update& update = window_[newest_];
  update.views.clear();
  update.ends.clear();
  for (const TrackGroup& group : groups) {
    for (const Contribution& contribution : group.contributions)
      update.views.push_back(view_of(group, contribution, index_of(contribution.track->newest().node_id)));
    update.ends.push_back(update.views.size());
  }
}

LearnedGeometry::Axes LearnedGeometry::position_axes(const View& view, const NodeQuality& quality) {
  return {quality.range_variance + view.aging, quality.bearing_variance * view.squared_range + view.aging};
}

LearnedGeometry::Axes LearnedGeometry::velocity_axes(const View& view, const NodeQuality& quality) {
  return {quality.range_rate_variance, quality.bearing_rate_variance * view.squared_range};
}

Eigen::Matrix2d LearnedGeometry::information(const View& view, const Axes& variances) {
  // I = u u'/s_r + v v'/(s_b r^2) = 1/across + (1/along - 1/across) u u'.
  const double along = 1.0 / variances.along, across = 1.0 / variances.across;
  const Eigen::Vector2d& u = view.line_of_sight;
  Eigen::Matrix2d result = (along - across) * u * u.transpose();
  result(0, 0) += across;
  result(1, 1) += across;
  return result;
}

Eigen::Matrix2d LearnedGeometry::information(const View& view) const {
  return information(view, position_axes(view, quality_[view.node]));
}

template <class InformationOf>
LearnedGeometry::Fix LearnedGeometry::weighted_fix(std::span<const View> views, Eigen::Vector2d View::*value,
                                                   const InformationOf& information_of) {
  // Relative to one of them, so that the regularisation pulls to the target and not to the earth's origin.
  const Eigen::Vector2d anchor = views.front().*value;
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
  for (const View& view : views) {
    const Eigen::Matrix2d own = information_of(view);
    sum += own;
    weighted += own * (view.*value - anchor);
  }
  sum += kRegularisation * sum.trace() * Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d covariance = sum.inverse();
  return {anchor + covariance * weighted, covariance};
}

LearnedGeometry::Fix LearnedGeometry::fix(std::span<const View> views) const {
  return weighted_fix(views, &View::position, [this](const View& s) { return information(s); });
}

LearnedGeometry::Fix LearnedGeometry::velocity_fix(std::span<const View> views) const {
  return weighted_fix(views, &View::velocity,
                      [this](const View& s) { return information(s, velocity_axes(s, quality_[s.node])); });
}

Eigen::Matrix4d LearnedGeometry::covariance_of(const TrackGroup& group,
                                               const Contribution& contribution) const {
  if (is_alone_with_covariance(group))
    return covariance_at(*contribution.track, group.utime, params_.process_noise);
  const View view = view_of(group, contribution, 0);
  const NodeQuality own = quality(contribution.track->newest().node_id);
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  covariance.topLeftCorner<2, 2>() = information(view, position_axes(view, own)).inverse();
  covariance.bottomRightCorner<2, 2>() = information(view, velocity_axes(view, own)).inverse();
  return covariance;
}

void LearnedGeometry::iterate() {
  moments_.assign(quality_.size(), Moments{});
  for (const Update& update : window_) {
    std::size_t begin = 0;
    for (std::size_t end : update.ends) {
      // A target that one node alone sees says nothing of that node's error.
      if (end - begin >= 2) {
        add_residuals({update.views.data() + begin, end - begin});
        add_velocity_residuals({update.views.data() + begin, end - begin});
      }
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
    const Eigen::Vector2d residual = view.position - fused.value;
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

void LearnedGeometry::add_velocity_residuals(std::span<const View> views) {
  const Fix fused = velocity_fix(views);
  for (const View& view : views) {
    const Eigen::Vector2d& u = view.line_of_sight;
    const Eigen::Vector2d v(-u.y(), u.x());
    const Eigen::Vector2d residual = view.velocity - fused.value;
    Moments& moments = moments_[view.node];
    moments.along_rate += std::pow(u.dot(residual), 2) + u.dot(fused.covariance * u);
    moments.across_rate += (std::pow(v.dot(residual), 2) + v.dot(fused.covariance * v)) / view.squared_range;
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
  learn_part(&Moments::along, &NodeQuality::range_variance);
  learn_part(&Moments::across, &NodeQuality::bearing_variance);
  learn_part(&Moments::along_rate, &NodeQuality::range_rate_variance);
  learn_part(&Moments::across_rate, &NodeQuality::bearing_rate_variance);
}

void LearnedGeometry::learn_part(double Moments::*sum, double NodeQuality::*variance) {
  const double extra = params_.pseudo_samples;
  const double median = median_of(sum);
  for (std::size_t node = 0; node < quality_.size(); ++node) {
    const Moments& moments = moments_[node];
    if (moments.count + extra == 0.0) continue;
    const double learned = (moments.*sum + extra * median) / (moments.count + extra);
    quality_[node].*variance = std::max(least_.*variance, learned);
  }
}

/// A filter of a target under white acceleration, once it has settled, errs in position and velocity by
/// variances sqrt(2) q^(1/4) r^(3/4) and sqrt(2) q^(3/4) r^(1/4) (the Riccati equation of constant velocity,
/// measurement noise r), so that the first says the second: 2^(1/3) q^(2/3) P^(1/3). No fusion of such
/// filters does better.
Eigen::Matrix2d LearnedGeometry::shared_velocity_error(const Eigen::Matrix2d& position) const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(position);
  const double scale = std::cbrt(2.0 * params_.process_noise * params_.process_noise);
  const Eigen::Vector2d variances =
      scale * axes.eigenvalues().unaryExpr([](double v) { return std::cbrt(v); });
  return axes.eigenvectors() * variances.asDiagonal() * axes.eigenvectors().transpose();
}

FusedState LearnedGeometry::fuse_group(const TrackGroup& group, std::span<const View> views) const {
  if (is_alone_with_covariance(group))
    return {group.contributions.front().current, covariance_of(group, group.contributions.front())};
  const Fix fused = fix(views);
  const Eigen::Vector2d anchor = group.contributions.front().current.tail<2>();
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const View& view : views) {
    const Eigen::Matrix2d own = information(view);
    weighted += own * (view.velocity - anchor);
    const Axes errors = velocity_axes(view, quality_[view.node]);
    spread += own * information(view, errors).inverse() * own;
  }
  FusedState result;
  result.state << fused.value, anchor + fused.covariance * weighted;
  result.covariance.topLeftCorner<2, 2>() = fused.covariance;
  result.covariance.bottomRightCorner<2, 2>() =
      fused.covariance * spread * fused.covariance + shared_velocity_error(fused.covariance);
  return result;
}

}  // namespace lookout::fusion
