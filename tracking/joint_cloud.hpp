#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "csht/sensor_likelihood.hpp"

namespace lookout::tracking {

/// Mean and covariance of a cloud over (north, east, north velocity, east velocity, north acceleration, east
/// acceleration).
struct CloudMoments {
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  Vector6 mean = Vector6::Zero();
  Matrix6 covariance = Matrix6::Zero();
};

/// Weighted trajectories of one target, each at the time of the newest scan: position, velocity and, for a
/// target that manoeuvres, a constant acceleration, earth frame, SI. Arrays of one size; the weights sum
/// to 1.
class JointCloud {
 public:
  std::vector<double> north, east, north_velocity, east_velocity, north_acceleration, east_acceleration;
  std::vector<double> weight;
  bool curved = false;  ///< Whether the accelerations are used; else they are zero.

  void resize(std::size_t size);
  void reserve(std::size_t size);  ///< Memory for as many, so that later sizes allocate nothing.
  std::size_t size() const { return north.size(); }

  /// Moves every trajectory on by `seconds`.
  void predict(double seconds);

  /// Takes the log-likelihood ratios of a new scan into the weights.
  /// @return ln of the mean likelihood ratio before the scan, the evidence for the target.
  double reweigh(std::span<const double> log_ratio);

  double effective_size() const;
  CloudMoments moments() const;
  int dimensions() const { return curved ? 6 : 4; }
  csht::HypothesisSpan span() const { return {north, east, north_velocity, east_velocity}; }
};

/// Turns `log_weight` into weights that sum to 1, written to `weight`. @return ln of the sum before.
double normalise_log_weights(std::span<const double> log_weight, std::span<double> weight);

}  // namespace lookout::tracking
