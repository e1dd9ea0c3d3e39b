#pragma once

#include <optional>
#include <vector>

#include "core/frames.hpp"
#include "core/pose_history.hpp"
#include "sonar_sim/sea/pose_errors.hpp"

namespace lookout::sonar_sim {

/// The end of one leg of a vehicle's route.
struct Waypoint {
  Eigen::Vector2d position{0, 0};  ///< North, east [m].
  double speed = 1.0;              ///< On the leg that ends here [m/s], > 0.
  std::optional<double> heading;   ///< Held on that leg [rad]; absent: along the leg.
};

/// What the navigation of a vehicle gets wrong. It never changes where the vehicle is.
struct NavigationFaults {
  double position_sigma = 0.0;    ///< Of north and of east in each report [m], >= 0.
  double heading_sigma = 0.0;     ///< [rad], >= 0.
  double time_jitter = 0.0;       ///< Reports are made up to this much off their usual time [s], >= 0.
  double loss_probability = 0.0;  ///< That a report is never sent, in [0, 1].
  double delay = 0.0;             ///< Reports arrive this much late [s], >= 0.
  PoseDrift drift = {};           ///< Errors that stay from report to report.
};

/// How the vehicle moves: at constant velocity, or along waypoints. Earth frame, SI.
struct VehiclePlan {
  Eigen::Vector2d position{0, 0};   ///< North, east [m] at time 0.
  Eigen::Vector2d velocity{0, 0};   ///< North, east [m/s]; not used where there are waypoints.
  std::optional<double> heading;    ///< Held [rad]; absent: along the velocity (along each leg).
  std::vector<Waypoint> waypoints;  ///< Passed in order from `position`; the vehicle stops at the last.
  double yaw_swing = 0.0;           ///< Amplitude of a sinusoid on top of the heading [rad], >= 0.
  double yaw_period = 20.0;         ///< Of that sinusoid [s], > 0.
  double turn_rate = core::radians(10.0);  ///< Fastest change of heading at a waypoint [rad/s], > 0.
  NavigationFaults navigation;             ///< What the reported states get wrong.
};

/// The vehicle's true state at any time. Positions follow the legs exactly; the heading swings to each leg's
/// at no more than the turn rate.
class VehicleMotion {
 public:
  /// @throws std::invalid_argument on a plan out of range.
  explicit VehicleMotion(const VehiclePlan& plan);

  /// True state at `time` >= 0 [s]; utime is filled.
  core::VehicleState at(double time) const;

 private:
  struct Leg {
    double start = 0.0;        ///< [s]
    double end = 0.0;          ///< [s]
    Eigen::Vector2d position;  ///< At the start.
    Eigen::Vector2d velocity;
    double heading_start = 0.0;  ///< [rad]
    double heading_goal = 0.0;   ///< [rad]
  };
  void add_leg(const Leg& leg);
  double heading_on(const Leg& leg, double time) const;

  std::vector<Leg> legs_;  ///< In order of time; the last never ends.
  double turn_rate_;
  double yaw_swing_, yaw_period_;
};

}  // namespace lookout::sonar_sim
