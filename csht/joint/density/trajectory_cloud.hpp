#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "csht/joint/density/motion_model.hpp"
#include "csht/likelihood/sensor_likelihood.hpp"

namespace lookout::csht {

/// Mean and covariance of a cloud's trajectories.
struct CloudMoments {
  Motion motion = Motion::line;
  Trajectory mean = Trajectory::Zero();
  TrajectoryCovariance covariance = TrajectoryCovariance::Zero();
};

/// Weighted trajectories of one target, each at the time of the newest scan: position, velocity and what
/// their motion needs, earth frame, SI. Arrays of one size; the weights sum to 1.
class TrajectoryCloud {
 public:
  std::vector<double> north, east, north_velocity, east_velocity;
  std::vector<double> north_acceleration, east_acceleration;  ///< Of a bend.
  std::vector<double> turn_rate;                              ///< Of a turn.
  std::vector<double> weight;
  Motion motion = Motion::line;  ///< Of all trajectories.

  void resize(std::size_t size);
  void reserve(std::size_t size);  ///< Memory for as many, so that later sizes allocate nothing.
  std::size_t size() const { return north.size(); }

  Trajectory trajectory(std::size_t i) const;

  /// The arrays that the motion uses, in the order of a `Trajectory`'s components; null beyond.
  std::array<double*, 6> components();
  std::array<const double*, 6> components() const;

  /// Moves every trajectory on by `seconds`.
  void predict(double seconds);

  /// Where every trajectory is `seconds` from now, to the positions of `at`. Vectorised.
  void place(double seconds, TrajectoryCloud& at) const;

  /// Takes the log-likelihood ratios of a new scan into the weights.
  /// @return ln of the mean likelihood ratio before the scan, the evidence for the target.
  double reweigh(std::span<const double> log_ratio);

  double effective_size() const;
  CloudMoments moments() const;
  HypothesisSpan span() const { return {north, east, north_velocity, east_velocity}; }
};

/// Turns `log_weight` into weights that sum to 1, written to `weight`. @return ln of the sum before.
double normalise_log_weights(std::span<const double> log_weight, std::span<double> weight);

}  // namespace lookout::csht
