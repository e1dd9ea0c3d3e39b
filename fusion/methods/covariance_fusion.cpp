#include "fusion/methods/covariance_fusion.hpp"

#include <Eigen/LU>

#include "core/parameter_check.hpp"

namespace lookout::fusion {

Eigen::Matrix4d covariance_at(const LocalTrack& track, std::int64_t utime, double q) {
  const double age = std::max(0.0, track.age(utime));
  const Eigen::Matrix4d F = core::constant_velocity_transition(age);
  return F * *track.newest().covariance * F.transpose() + core::white_acceleration_noise(age, q);
}

CovarianceFusion::CovarianceFusion(CovarianceWeights weights, double q) : weights_(weights), q_(q) {
  core::require(q >= 0.0, "process_noise must be >= 0", q);
}

std::span<const FusedState> CovarianceFusion::fuse(std::span<const TrackGroup> groups) {
  fused_.clear();
  for (const TrackGroup& group : groups) fused_.push_back(fuse_group(group));
  return fused_;
}

FusedState CovarianceFusion::fuse_group(const TrackGroup& group) const {
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  Eigen::Vector4d weighted = Eigen::Vector4d::Zero();
  double sum_of_weights = 0.0;
  for (const Contribution& contribution : group.contributions) {
    const Eigen::Matrix4d covariance = covariance_at(*contribution.track, group.utime, q_);
    const double weight = weights_ == CovarianceWeights::sum ? 1.0 : 1.0 / covariance.trace();
    const Eigen::Matrix4d own = weight * covariance.inverse();
    information += own;
    weighted += own * contribution.current;
    sum_of_weights += weight;
  }
  if (weights_ == CovarianceWeights::sum) sum_of_weights = 1.0;
  FusedState result;
  result.covariance = (information / sum_of_weights).inverse();
  result.state = result.covariance * weighted / sum_of_weights;
  return result;
}

}  // namespace lookout::fusion
