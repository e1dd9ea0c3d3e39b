#pragma once

#include "core/sonar_params.hpp"
#include "tracking/baselines/gaussian/gaussian_target.hpp"

namespace lookout::tracking {

/// How targets of the rivals move. Speeds are in units of the sensor's `max_speed`, times in scan periods.
struct SwitchingMotionParams {
  int models = 2;  ///< Of motion, 1 to 2: steady alone, or steady and manoeuvring. [Blom1988]
  /// By how much a velocity component of a steady target changes in a scan period, one standard deviation
  /// [max_speed], >= 0.
  double steady_walk = 0.001;
  double turning_walk = 0.05;   ///< The same of a manoeuvring target [max_speed], >= 0.
  double steady_scans = 500.0;  ///< Mean scan periods until a manoeuvre begins, > 0.
  double turning_scans = 20.0;  ///< Mean scan periods until it ends, > 0.
  double first_speed = 0.35;  ///< Standard deviation of a new target's velocity components [max_speed], > 0.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// Constant velocity disturbed by white acceleration, of one strength or switching between two.
class SwitchingMotion {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  SwitchingMotion(const SwitchingMotionParams& params, const core::SonarParams& sonar);

  /// A target first seen here: velocity zero, as uncertain as `first_speed` says.
  GaussianTarget born(const PositionMeasurement& measurement) const;

  /// Carries a target `seconds` >= 0 ahead: its models interact, then each moves. [Blom1988]
  void predict(GaussianTarget& target, double seconds) const;

 private:
  void interact(GaussianTarget& target, double seconds) const;

  SwitchingMotionParams params_;
  double scan_period_;                                             // [s]
  double speed_variance_;                                          // Of a new target's velocity [m^2/s^2].
  std::array<double, GaussianTarget::kMostModes> density_{};       // Of the white acceleration [m^2/s^3].
  std::array<double, GaussianTarget::kMostModes> first_weight_{};  // Of the models in the long run.
};

}  // namespace lookout::tracking
