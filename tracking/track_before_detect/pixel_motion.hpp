#pragma once

#include <Eigen/Core>

namespace lookout::tracking {

/// Constant-velocity transition over `step` for the state (x, y, x velocity, y velocity). [Pakfiliz2018] Eq.
/// (26), the state reordered.
inline Eigen::Matrix4d constant_velocity_transition(double step) {
  Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
  F(0, 2) = F(1, 3) = step;
  return F;
}

/// Process noise of white acceleration with power spectral density `density` over `step`. Eq. (26).
inline Eigen::Matrix4d white_acceleration_noise(double density, double step) {
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q.diagonal() << step * step * step / 3.0, step * step * step / 3.0, step, step;
  Q(0, 2) = Q(2, 0) = Q(1, 3) = Q(3, 1) = step * step / 2.0;
  return density * Q;
}

}  // namespace lookout::tracking
