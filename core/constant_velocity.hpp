#pragma once

#include <Eigen/Core>

/// The motion that all share: constant velocity disturbed by white acceleration. States are (first position,
/// second position, first velocity, second velocity): north and east, or x and y of an image in pixels.
namespace lookout::core {

/// Transition of the state over `seconds`, negative ones back. [Li2018] Eq. (20) without turn, its two
/// misprinted elements corrected; [Pakfiliz2018] Eq. (26), the state reordered.
Eigen::Matrix4d constant_velocity_transition(double seconds);

/// Covariance that white acceleration of spectral density `density` >= 0 [m^2/s^3] adds over `seconds` >= 0.
/// [BarShalom2001] Eq. (6.2.2-12) for either axis.
Eigen::Matrix4d white_acceleration_noise(double seconds, double density);

/// Covariance that an acceleration of standard deviation `sigma` [m/s^2] adds, constant over `seconds` and
/// drawn anew for the next. [BarShalom2001] Eq. (6.3.2-4) for either axis.
Eigen::Matrix4d stepwise_acceleration_noise(double seconds, double sigma);

/// The state `seconds` later, earlier where negative.
Eigen::Vector4d moved(const Eigen::Vector4d& state, double seconds);

}  // namespace lookout::core
