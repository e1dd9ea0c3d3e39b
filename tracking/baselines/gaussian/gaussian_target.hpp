#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

namespace lookout::tracking {

/// A measured position, earth frame.
struct PositionMeasurement {
  Eigen::Vector2d position{0, 0};                       ///< North, east [m].
  Eigen::Matrix2d noise = Eigen::Matrix2d::Identity();  ///< Its covariance [m^2], positive definite.
};

/// A Gaussian density of (north, east, north velocity, east velocity), SI, under one model of motion.
struct GaussianMode {
  double weight = 1.0;                                   ///< Probability of the model, in [0, 1].
  Eigen::Vector4d mean{0, 0, 0, 0};                      ///< [m], [m/s].
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< Of `mean`.
};

/// What is believed of one target: a Gaussian for each model of motion, as the interacting multiple model
/// filter holds it. [Blom1988]
struct GaussianTarget {
  static constexpr int kMostModes = 2;         ///< Most models of motion.
  std::array<GaussianMode, kMostModes> modes;  ///< The first `num_modes` count; their weights sum to 1.
  int num_modes = 1;                           ///< 1 or 2.

  /// The modes that count.
  std::span<const GaussianMode> used() const { return {modes.data(), static_cast<std::size_t>(num_modes)}; }
  /// The same, to change them.
  std::span<GaussianMode> used() { return {modes.data(), static_cast<std::size_t>(num_modes)}; }
  Eigen::Vector4d mean() const;        ///< Over the modes.
  Eigen::Matrix4d covariance() const;  ///< Over the modes, their spread included.
};

/// Probability density of a measurement before it is made [1/m^2].
double density(const GaussianTarget& target, const PositionMeasurement& measurement);

/// Least squared Mahalanobis distance of a measurement from a mode's prediction.
double squared_distance(const GaussianTarget& target, const PositionMeasurement& measurement);

/// The target given that the measurement is its own: each mode by Kalman's update, the weights by Bayes.
/// [Blom1988]; the measured position is taken as linear in the state ([BarShalom2001] Sec. 10.4).
GaussianTarget updated(const GaussianTarget& target, const PositionMeasurement& measurement);

}  // namespace lookout::tracking
