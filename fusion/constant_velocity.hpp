#pragma once

#include <Eigen/Core>

/// The motion model that nodes and fusion share: constant velocity with white acceleration.
namespace lookout::fusion {

/// Transition over `dt` [s] of (north, east, north velocity, east velocity). [Li2018] Eq. (20) without
/// turn, the two misprinted elements corrected.
inline Eigen::Matrix4d transition(double dt) {
  Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
  F(0, 2) = F(1, 3) = dt;
  return F;
}

/// Covariance that white acceleration of density `q` [m^2/s^3] adds over `dt` >= 0 [s].
inline Eigen::Matrix4d process_noise(double dt, double q) {
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q(0, 0) = Q(1, 1) = q * dt * dt * dt / 3.0;
  Q(0, 2) = Q(2, 0) = Q(1, 3) = Q(3, 1) = q * dt * dt / 2.0;
  Q(2, 2) = Q(3, 3) = q * dt;
  return Q;
}

/// The state `dt` [s] later (earlier where negative).
inline Eigen::Vector4d moved(const Eigen::Vector4d& state, double dt) {
  return {state(0) + dt * state(2), state(1) + dt * state(3), state(2), state(3)};
}

}  // namespace lookout::fusion
