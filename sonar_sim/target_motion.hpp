#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

namespace lookout::sonar_sim {

/// How one target moves: straight, on a circle, or changing its speed. Earth frame, SI.
struct TargetPlan {
  std::int32_t id = 0;             ///< Unique in its scene.
  Eigen::Vector2d position{0, 0};  ///< North, east [m] at time 0.
  Eigen::Vector2d velocity{0, 0};  ///< North, east [m/s] at time 0.
  double turn_rate = 0.0;          ///< Of the velocity, clockwise [rad/s].
  double acceleration = 0.0;       ///< Along the velocity [m/s^2]; a negative one ends by moving backwards.
  std::optional<double> snr_db;    ///< In images [dB], see ImagePlan; absent: the plan's.
  double appear = 0.0;             ///< Present for appear <= t < disappear [s].
  double disappear = 1e9;          ///< [s], > appear.

  /// Whether it is scheduled at `time` [s].
  bool present(double time) const { return time >= appear && time < disappear; }
};

/// Position and velocity of a target at one time.
struct TargetState {
  Eigen::Vector2d position{0, 0};  ///< North, east [m].
  Eigen::Vector2d velocity{0, 0};  ///< North, east [m/s].
};

/// The state at `time` [s], in closed form for constant turn rate and constant acceleration together.
TargetState target_state(const TargetPlan& plan, double time);

}  // namespace lookout::sonar_sim
