#include "fusion/methods/maximum_likelihood_fusion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <optional>

#include "core/parameter_check.hpp"
#include "fusion/methods/covariance_fusion.hpp"

namespace lookout::fusion {
namespace {

/// Two local tracks that were not fused for so long begin anew [s].
constexpr double kForgetAfter = 60.0;

/// The estimate of `track` at exactly `utime`, by its place before the newest.
std::optional<std::size_t> place_of(const LocalTrack& track, std::int64_t utime) {
  for (std::size_t age = 0; age < track.size(); ++age) {
    if (track.back(age).utime == utime) return age;
  }
  return std::nullopt;
}

/// The time of the first estimate of `track` after `utime`.
std::optional<std::int64_t> next_event(const LocalTrack& track, std::int64_t utime) {
  for (std::size_t age = track.size(); age-- > 0;) {
    if (track.back(age).utime > utime) return track.back(age).utime;
  }
  return std::nullopt;
}

/// I - W H of the estimate at `utime`; the identity where there is none with one before it.
Eigen::Matrix4d gain(const LocalTrack& track, std::int64_t utime, double q) {
  const auto place = place_of(track, utime);
  if (!place || *place + 1 >= track.size()) return Eigen::Matrix4d::Identity();
  const LocalEstimate& newer = track.back(*place);
  const LocalEstimate& older = track.back(*place + 1);
  const double dt = core::seconds(newer.utime - older.utime);
  const Eigen::Matrix4d F = core::constant_velocity_transition(dt);
  const Eigen::Matrix4d predicted =
      F * *older.covariance * F.transpose() + core::white_acceleration_noise(dt, q);
  return *newer.covariance * predicted.inverse();
}

}  // namespace

MaximumLikelihoodFusion::MaximumLikelihoodFusion(const KalmanModel& model) : model_(model) {
  core::require_not_negative("process_noise", model.process_noise);
  core::require_positive("velocity_sigma", model.velocity_sigma);
}

std::span<const FusedState> MaximumLikelihoodFusion::fuse(std::span<const TrackGroup> groups) {
  fused_.clear();
  for (const TrackGroup& group : groups) fused_.push_back(fuse_group(group));
  if (groups.empty()) return fused_;
  const std::int64_t now = groups.front().utime;
  std::erase_if(cross_,
                [&](const auto& entry) { return core::seconds(now - entry.second.utime) > kForgetAfter; });
  return fused_;
}

MaximumLikelihoodFusion::Cross MaximumLikelihoodFusion::first_cross(const LocalTrack& a,
                                                                    const LocalTrack& b) const {
  const std::int64_t first_of_a = a.back(a.size() - 1).utime, first_of_b = b.back(b.size() - 1).utime;
  Cross cross{Eigen::Matrix4d::Zero(), std::max(first_of_a, first_of_b)};
  // Filters whose start is no longer kept, or that began apart, count as independent there.
  const bool starts_kept = a.heard() == a.size() && b.heard() == b.size();
  if (!starts_kept || first_of_a != first_of_b) return cross;
  // Both filters start from one measured position and no velocity: the true velocity is their common error.
  const double variance = model_.velocity_sigma * model_.velocity_sigma;
  cross.covariance.bottomRightCorner<2, 2>().diagonal().setConstant(variance);
  return cross;
}

void MaximumLikelihoodFusion::advance(Cross& cross, const LocalTrack& a, const LocalTrack& b,
                                      std::int64_t utime) const {
  while (cross.utime < utime) {
    const std::int64_t next = std::min(
        {next_event(a, cross.utime).value_or(utime), next_event(b, cross.utime).value_or(utime), utime});
    const double dt = core::seconds(next - cross.utime);
    const Eigen::Matrix4d F = core::constant_velocity_transition(dt);
    const Eigen::Matrix4d predicted =
        F * cross.covariance * F.transpose() + core::white_acceleration_noise(dt, model_.process_noise);
    cross.covariance = gain(a, next, model_.process_noise) * predicted *
                       gain(b, next, model_.process_noise).transpose();  // docs/fusion.md, C_ij(k)
    cross.utime = next;
  }
}

Eigen::Matrix4d MaximumLikelihoodFusion::cross_covariance(const LocalTrack& a, const LocalTrack& b,
                                                          std::int64_t utime) {
  const Pair pair{{a.newest().node_id, a.newest().track_id}, {b.newest().node_id, b.newest().track_id}};
  const auto [entry, is_new] = cross_.try_emplace(pair);
  if (is_new) entry->second = first_cross(a, b);
  advance(entry->second, a, b, utime);
  return entry->second.covariance;
}

FusedState MaximumLikelihoodFusion::fuse_group(const TrackGroup& group) {
  const auto n = static_cast<Eigen::Index>(group.contributions.size());
  Eigen::MatrixXd joint(4 * n, 4 * n), ones(4 * n, 4);
  Eigen::VectorXd stacked(4 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Contribution& own = group.contributions[static_cast<std::size_t>(i)];
    stacked.segment<4>(4 * i) = own.current;
    ones.middleRows<4>(4 * i).setIdentity();
    joint.block<4, 4>(4 * i, 4 * i) = covariance_at(*own.track, group.utime, model_.process_noise);
    for (Eigen::Index j = 0; j < i; ++j) {
      const Contribution& other = group.contributions[static_cast<std::size_t>(j)];
      const Eigen::Matrix4d cross = cross_covariance(*own.track, *other.track, group.utime);
      joint.block<4, 4>(4 * i, 4 * j) = cross;
      joint.block<4, 4>(4 * j, 4 * i) = cross.transpose();
    }
  }
  const Eigen::MatrixXd weighted = joint.ldlt().solve(ones);  // C^-1 E
  FusedState result;
  result.covariance = (ones.transpose() * weighted).inverse();
  result.state = result.covariance * weighted.transpose() * stacked;  // (E' C^-1 E)^-1 E' C^-1 x
  return result;
}

}  // namespace lookout::fusion
