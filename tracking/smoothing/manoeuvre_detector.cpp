#include "tracking/smoothing/manoeuvre_detector.hpp"

#include <Eigen/Cholesky>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
void ManoeuvreParams::validate() const {
  core::require_inner_share("manoeuvre: share", share);
  core::require(threshold > 0.0, "manoeuvre: threshold must be > 0", threshold);
  core::require_not_negative("manoeuvre: position_variance", position_variance);
  core::require_not_negative("manoeuvre: velocity_variance", velocity_variance);
}

ManoeuvreDetector::ManoeuvreDetector(const ManoeuvreParams& params) : params_(params) {
  params_.validate();
}

bool ManoeuvreDetector::notice(core::Track& track, Eigen::Vector2d& drift, const Eigen::Vector2d& position,
                               const Eigen::Matrix2d& noise) const {
  const Eigen::Matrix2d innovation = track.covariance.topLeftCorner<2, 2>() + noise;
  const Eigen::Vector2d whitened = innovation.llt().matrixL().solve(position - track.position());
  drift = (1.0 - params_.share) * drift + params_.share * whitened;
  // The running mean of independent unit variables has the variance share / (2 - share).
  if (drift.squaredNorm() * (2.0 - params_.share) / params_.share <= params_.threshold) return false;
  drift.setZero();
  track.covariance.diagonal().head<2>().array() += params_.position_variance;
  track.covariance.diagonal().tail<2>().array() += params_.velocity_variance;
  return true;
}

}  // namespace lookout::tracking
