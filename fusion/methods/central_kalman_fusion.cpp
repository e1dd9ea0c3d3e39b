#include "fusion/methods/central_kalman_fusion.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "core/parameter_check.hpp"

namespace lookout::fusion {
namespace {

/// A global track without support for so long will not come back [s].
constexpr double kForgetAfter = 60.0;

/// Projector on the directions in which `matrix` is positive: a node that is no Kalman filter may seem to
/// lose information in others.
Eigen::Matrix4d positive_part(const Eigen::Matrix4d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(0.5 * (matrix + matrix.transpose()));
  const Eigen::Vector4d keep = (solver.eigenvalues().array() > 0.0).cast<double>();
  return solver.eigenvectors() * keep.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

CentralKalmanFusion::CentralKalmanFusion(const KalmanModel& model) : model_(model) {
  core::require_not_negative("process_noise", model.process_noise);
  core::require_positive("velocity_sigma", model.velocity_sigma);
}

std::span<const FusedState> CentralKalmanFusion::fuse(std::span<const TrackGroup> groups) {
  for (auto& [id, filter] : filters_) filter.used = false;
  fused_.clear();
  for (const TrackGroup& group : groups) fused_.push_back(fuse_group(group));
  std::erase_if(filters_, [&](const auto& entry) {
    return !entry.second.used && !groups.empty() &&
           core::seconds(groups.front().utime - entry.second.utime) > kForgetAfter;
  });
  return fused_;
}

CentralKalmanFusion::Information CentralKalmanFusion::prior() const {
  Information information;
  const double variance = model_.velocity_sigma * model_.velocity_sigma;
  information.matrix.bottomRightCorner<2, 2>().diagonal().setConstant(1.0 / variance);
  return information;
}

CentralKalmanFusion::Information CentralKalmanFusion::told_by(const LocalTrack& track,
                                                              std::size_t place) const {
  const LocalEstimate& newer = track.back(place);
  Information before = prior();
  if (place + 1 < track.size()) {
    const LocalEstimate& older = track.back(place + 1);
    const double dt = core::seconds(newer.utime - older.utime);
    const Eigen::Matrix4d F = core::constant_velocity_transition(dt);
    before.matrix =
        (F * *older.covariance * F.transpose() + core::white_acceleration_noise(dt, model_.process_noise))
            .inverse();
    before.vector = before.matrix * core::moved(older.state, dt);
  }
  const Eigen::Matrix4d after = newer.covariance->inverse();
  const Eigen::Matrix4d matrix = after - before.matrix;
  const Eigen::Matrix4d positive = positive_part(matrix);
  return {positive * matrix * positive, positive * (after * newer.state - before.vector)};
}

void CentralKalmanFusion::collect_events(const TrackGroup& group, std::int64_t after) {
  events_.clear();
  for (const Contribution& contribution : group.contributions) {
    const LocalTrack& track = *contribution.track;
    for (std::size_t place = 0; place < track.size() && track.back(place).utime > after; ++place)
      events_.push_back({track.back(place).utime, told_by(track, place)});
  }
  std::stable_sort(events_.begin(), events_.end(),
                   [](const Event& a, const Event& b) { return a.utime < b.utime; });
}

CentralKalmanFusion::Filter CentralKalmanFusion::first_filter(const TrackGroup& group) const {
  std::int64_t first = group.utime;
  for (const Contribution& contribution : group.contributions) {
    const LocalTrack& track = *contribution.track;
    first = std::min(first, track.back(track.size() - 1).utime);
  }
  return {prior(), first - 1, true};  // A microsecond before, so that the first estimates are events too.
}

void CentralKalmanFusion::predict(Filter& filter, std::int64_t utime) const {
  const double dt = core::seconds(utime - filter.utime);
  filter.utime = utime;
  if (filter.belief.matrix.topLeftCorner<2, 2>().isZero()) return;  // No position yet: nothing moves.
  const Eigen::Matrix4d F = core::constant_velocity_transition(dt);
  const Eigen::Matrix4d covariance = filter.belief.matrix.inverse();
  const Eigen::Vector4d state = core::moved(covariance * filter.belief.vector, dt);
  filter.belief.matrix =
      (F * covariance * F.transpose() + core::white_acceleration_noise(dt, model_.process_noise)).inverse();
  filter.belief.vector = filter.belief.matrix * state;
}

FusedState CentralKalmanFusion::fuse_group(const TrackGroup& group) {
  const auto [entry, is_new] = filters_.try_emplace(group.global_id);
  Filter& filter = entry->second;
  if (is_new) filter = first_filter(group);
  filter.used = true;
  collect_events(group, filter.utime);
  for (const Event& event : events_) {
    predict(filter, event.utime);
    filter.belief.matrix += event.added.matrix;
    filter.belief.vector += event.added.vector;
  }
  const double dt = core::seconds(group.utime - filter.utime);
  const Eigen::Matrix4d F = core::constant_velocity_transition(dt),
                        covariance = filter.belief.matrix.inverse();
  return {core::moved(covariance * filter.belief.vector, dt),
          F * covariance * F.transpose() + core::white_acceleration_noise(dt, model_.process_noise)};
}

}  // namespace lookout::fusion
