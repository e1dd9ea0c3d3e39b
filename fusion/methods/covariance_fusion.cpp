#include "fusion/methods/covariance_fusion.hpp"

#include <Eigen/LU>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::fusion {
namespace {

/// Steps towards the least trace: within a thousandth of it for ellipses of 1 : 30 (test).
constexpr int kRounds = 30;

}  // namespace

Eigen::Matrix4d covariance_at(const LocalTrack& track, std::int64_t utime, double q) {
  const double age = std::max(0.0, track.age(utime));
  const Eigen::Matrix4d F = core::constant_velocity_transition(age);
  return F * *track.newest().covariance * F.transpose() + core::white_acceleration_noise(age, q);
}

CovarianceFusion::CovarianceFusion(CovarianceWeights weights, double q) : weights_(weights), q_(q) {
  core::require_not_negative("process_noise", q);
}

std::span<const FusedState> CovarianceFusion::fuse(std::span<const TrackGroup> groups) {
  fused_.clear();
  for (const TrackGroup& group : groups) fused_.push_back(fuse_group(group));
  return fused_;
}

FusedState CovarianceFusion::fuse_group(const TrackGroup& group) {
  information_.clear();
  for (const Contribution& contribution : group.contributions)
    information_.push_back(covariance_at(*contribution.track, group.utime, q_).inverse());
  choose_weights();
  if (weights_ == CovarianceWeights::least_trace) {
    for (int round = 0; round < kRounds; ++round) improve_weights();
  }
  FusedState result;
  result.covariance = fused_covariance();
  for (std::size_t i = 0; i < weight_.size(); ++i)
    result.state += weight_[i] * information_[i] * group.contributions[i].current;
  result.state = (result.covariance * result.state).eval();
  return result;
}

/// 1/trace, where they are to have sum 1.
void CovarianceFusion::choose_weights() {
  weight_.assign(information_.size(), 1.0);
  if (weights_ == CovarianceWeights::sum) return;
  double sum = 0.0;
  for (std::size_t i = 0; i < weight_.size(); ++i) {
    weight_[i] = 1.0 / information_[i].inverse().trace();
    sum += weight_[i];
  }
  for (double& weight : weight_) weight /= sum;
}

Eigen::Matrix4d CovarianceFusion::fused_covariance() const {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (std::size_t i = 0; i < weight_.size(); ++i) sum += weight_[i] * information_[i];
  return sum.inverse();
}

/// One step of the multiplicative algorithm for a least trace [Yu2010]: each weight grows with the square
/// root of how much a little more of it would take off the trace.
void CovarianceFusion::improve_weights() {
  const Eigen::Matrix4d covariance = fused_covariance();
  double sum = 0.0;
  for (std::size_t i = 0; i < weight_.size(); ++i) {
    weight_[i] *= std::sqrt((covariance * information_[i] * covariance).trace());
    sum += weight_[i];
  }
  for (double& weight : weight_) weight /= sum;
}

}  // namespace lookout::fusion
