#include "core/constant_velocity.hpp"

namespace lookout::core {

Eigen::Matrix4d constant_velocity_transition(double seconds) {
  Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
  F(0, 2) = F(1, 3) = seconds;
  return F;
}

Eigen::Matrix4d white_acceleration_noise(double seconds, double density) {
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q(0, 0) = Q(1, 1) = density * seconds * seconds * seconds / 3.0;
  Q(0, 2) = Q(2, 0) = Q(1, 3) = Q(3, 1) = density * seconds * seconds / 2.0;
  Q(2, 2) = Q(3, 3) = density * seconds;
  return Q;
}

Eigen::Matrix4d stepwise_acceleration_noise(double seconds, double sigma) {
  Eigen::Matrix<double, 4, 2> gain;
  gain << 0.5 * seconds * seconds * Eigen::Matrix2d::Identity(), seconds * Eigen::Matrix2d::Identity();
  return sigma * sigma * gain * gain.transpose();
}

Eigen::Vector4d moved(const Eigen::Vector4d& state, double seconds) {
  return {state(0) + seconds * state(2), state(1) + seconds * state(3), state(2), state(3)};
}

}  // namespace lookout::core
