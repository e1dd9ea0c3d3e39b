#include "tracking/smoothing/constant_velocity_filter.hpp"

#include <Eigen/LU>

#include "core/constant_velocity.hpp"
#include "core/parameter_check.hpp"

namespace lookout::tracking {

void MotionModelParams::validate() const {
  core::require_not_negative("acceleration_sigma", acceleration_sigma);
}

void predict(core::Track& track, double seconds, const MotionModelParams& motion) {
  const Eigen::Matrix4d F = core::constant_velocity_transition(seconds);
  track.state = F * track.state;
  track.covariance = F * track.covariance * F.transpose() +
                     core::stepwise_acceleration_noise(seconds, motion.acceleration_sigma);
}

void update(core::Track& track, const Eigen::Vector2d& position, const Eigen::Matrix2d& noise) {
  const Eigen::Matrix2d innovation = track.covariance.topLeftCorner<2, 2>() + noise;
  const Eigen::Matrix<double, 4, 2> gain = track.covariance.leftCols<2>() * innovation.inverse();
  track.state += gain * (position - track.position());
  Eigen::Matrix4d keep = Eigen::Matrix4d::Identity();
  keep.leftCols<2>() -= gain;
  track.covariance = keep * track.covariance * keep.transpose() + gain * noise * gain.transpose();
}

}  // namespace lookout::tracking
