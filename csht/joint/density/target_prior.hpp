#pragma once

#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// What is believed of targets before anything is seen of them.
struct TargetPriorParams {
  double expected_targets = 2.0;  ///< In the field of view at any time, > 0.
  double interior_rate = 0.002;   ///< Targets that appear inside the field of view [1/s], >= 0.
  /// A sonar that starts may not show at once all that is there: during the first seconds [s], >= 0, so many
  /// more come into sight [1/s], >= 0. docs/joint_estimator.md.
  double settling_s = 2.0, settling_rate = 2.0;
  double speed_sigmas = 3.0;  ///< The speed limit in standard deviations of a velocity component, > 0.
  double speed_edge = 0.2;    ///< Beyond the limit densities fall off with this sigma [m/s], > 0.
  /// Velocities evenly spread over the disc of possible ones in place of normal components.
  bool uniform_speeds = false;
  /// All targets are in view from the oldest scan on: a single window's experiment, [Yan2018] Table 2.
  bool in_view_from_start = false;
};

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const TargetPriorParams& params);

/// The prior of the joint tracker: targets evenly spread over the field of view and beyond, their velocities
/// normal, as many entering over the border as that brings, a few appearing inside.
class TargetPrior {
 public:
  /// @param params validated. @param max_speed of a target [m/s], > 0. @param scan_period [s], > 0.
  explicit TargetPrior(const TargetPriorParams& params = {}, double max_speed = 3.0,
                       double scan_period = 0.5);

  double max_speed() const { return max_speed_; }
  double velocity_sigma() const { return velocity_sigma_; }  ///< Of each component [m/s].

  /// ln of how much less probable a velocity is than standing still. @param speed [m/s].
  double log_speed(double speed) const;
  /// ln of what is left of any density of speeds at this one: 0 up to the limit, falling off beyond it.
  double log_edge(double speed) const;

  /// ln of the density of targets that stand in view of `scan`, over position and velocity, at velocity 0
  /// [1 / (m^2 (m/s)^2)].
  double log_standing(const ScanTable& scan) const;

  /// Targets that come into sight inside at a scan so long after the first.
  double appearing(double seconds_since_first) const;
  /// ln of the same, relative to those that stand there.
  double log_birth(double seconds_since_first) const;

  /// Targets that enter over the border within `seconds`.
  double entering(const ScanTable& scan, double seconds) const;

  double expected_targets() const { return params_.expected_targets; }
  /// Replaces the expected number of targets, > 0, as it is learnt.
  void set_expected_targets(double expected);
  bool in_view_from_start() const { return params_.in_view_from_start; }

 private:
  TargetPriorParams params_;
  double max_speed_;
  double velocity_sigma_;
  double settling_, settled_;  ///< Targets that appear inside at a scan, while the sonar settles and later.
  double log_settling_, log_settled_;  ///< log_birth of either time.
};

}  // namespace lookout::csht
