#pragma once

#include "core/frames.hpp"
#include "core/random.hpp"

namespace lookout::sonar_sim {

/// Errors of navigation that stay: they move all that the vehicle reports of its pose, never the vehicle.
struct PoseDrift {
  double heading_bias = 0.0;   ///< Constant [rad].
  double heading_drift = 0.0;  ///< Growth with time, as of a free gyro [rad/s].
  double heading_walk = 0.0;   ///< Standard deviation of a random walk after one second [rad], >= 0.
  double position_walk = 0.0;  ///< The same of north and of east, as of dead reckoning [m], >= 0.
};

/// The error of the pose over time: bias + drift t + walk(t), the walk a Brownian motion that begins at 0, so
/// that it is the same whatever the period of the reports.
class PoseErrors {
 public:
  /// @param drift what navigation gets wrong. @param random its own stream.
  PoseErrors(const PoseDrift& drift, core::Random random);

  /// The error to add to the true pose at `time` [s].
  /// @param time not before that of the call before.
  core::Pose2 at(double time);

 private:
  PoseDrift drift_;
  core::Random random_;
  double time_ = 0.0;
  core::Pose2 walk_;
};

}  // namespace lookout::sonar_sim
