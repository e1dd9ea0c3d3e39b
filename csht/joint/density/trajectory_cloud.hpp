#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "csht/joint/density/motion_model.hpp"
#include "csht/likelihood/sensor_likelihood.hpp"

namespace lookout::csht {

/// Mean and covariance of a cloud's trajectories, units and frame as in `Trajectory`.
struct CloudMoments {
  Motion motion = Motion::constant_velocity;  ///< Says which components count.
  Trajectory mean = Trajectory::Zero();       ///< Weighted.
  /// Weighted; zero for components that do not count.
  TrajectoryCovariance covariance = TrajectoryCovariance::Zero();
};

/// Weighted trajectories of one target, each at the time of the newest scan: position, velocity and what
/// their motion needs, earth frame, SI. Arrays of one size; the weights sum to 1.
class TrajectoryCloud {
 public:
  std::vector<double> north, east;                            ///< Positions [m].
  std::vector<double> north_velocity, east_velocity;          ///< [m/s].
  std::vector<double> north_acceleration, east_acceleration;  ///< Constant acceleration alone [m/s^2].
  std::vector<double> turn_rate;                              ///< Constant turn alone [rad/s].
  std::vector<double> weight;                                 ///< Probabilities.
  Motion motion = Motion::constant_velocity;                  ///< Of all trajectories.

  void resize(std::size_t size);   ///< The arrays; what is new in them is not set.
  void reserve(std::size_t size);  ///< Memory for as many, so that later sizes allocate nothing.
  std::size_t size() const { return north.size(); }  ///< How many trajectories.

  Trajectory trajectory(std::size_t i) const;  ///< The i-th, i < size().

  /// The arrays that the motion uses, in the order of a `Trajectory`'s components; null beyond.
  std::array<double*, 6> components();
  /// The same, read only.
  std::array<const double*, 6> components() const;

  /// Moves every trajectory on by `seconds`.
  void predict(double seconds);

  /// Writes where every trajectory is `seconds` from now to the positions of `at`, and no more of it.
  /// Vectorised. Not for constant velocity, whose trajectories the likelihood moves by itself.
  void place(double seconds, TrajectoryCloud& at) const;

  /// Takes the log-likelihood ratios of a new scan [nats], one a trajectory, into the weights: the update of
  /// a particle filter, [Gordon1993].
  /// @return ln of the mean likelihood ratio under the weights before: the evidence for the target [nats].
  double reweigh(std::span<const double> log_ratio);

  double effective_size() const;  ///< 1 / sum of the squared weights, 1 to size(). [Arulampalam2002] Sec. V.
  CloudMoments moments() const;   ///< Mean and covariance of the trajectories.
  /// Positions and velocities as the likelihood takes them.
  HypothesisSpan span() const { return {north, east, north_velocity, east_velocity}; }
};

/// Turns `log_weight` into weights that sum to 1, written to `weight`. @return ln of the sum before.
double normalise_log_weights(std::span<const double> log_weight, std::span<double> weight);

}  // namespace lookout::csht
