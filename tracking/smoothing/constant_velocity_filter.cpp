#include "tracking/smoothing/constant_velocity_filter.hpp"

#include <Eigen/LU>
#include <stdexcept>
#include <string>

namespace lookout::tracking {

void MotionModelParams::validate() const {
  if (!(acceleration_sigma >= 0.0))
    throw std::invalid_argument("acceleration_sigma must be >= 0, got " + std::to_string(acceleration_sigma));
}

void predict(core::Track& track, double seconds, const MotionModelParams& motion) {
  Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
  transition.topRightCorner<2, 2>() = seconds * Eigen::Matrix2d::Identity();
  Eigen::Matrix<double, 4, 2> gain;
  gain << 0.5 * seconds * seconds * Eigen::Matrix2d::Identity(), seconds * Eigen::Matrix2d::Identity();
  const double variance = motion.acceleration_sigma * motion.acceleration_sigma;
  track.state = transition * track.state;
  track.covariance =
      transition * track.covariance * transition.transpose() + variance * gain * gain.transpose();
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
