#pragma once

#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// What is believed of targets before anything is seen of them.
struct TargetPriorParams {
  double expected_targets = 2.0;  ///< In the field of view at any time, > 0.
  double interior_rate = 0.002;   ///< Targets that appear inside the field of view [1/s], >= 0.
  /// A sonar that starts may not show at once all that is there. For so long after the first scan [s], >= 0,
  double settling_s = 2.0;
  double settling_rate = 2.0;  ///< so many more targets appear [1/s], >= 0. docs/joint_estimator.md.
  double speed_sigmas = 3.0;   ///< The fastest target's speed over the sigma of a velocity component, > 0.
  /// Beyond the speed limit the density falls off as a normal one of this sigma [m/s], > 0.
  double speed_edge = 0.2;
  /// Velocities evenly spread over the disc of possible ones in place of normal components.
  bool uniform_speeds = false;
  /// All targets are in view from the oldest scan on: a single window's experiment, [Yan2018] Table 2.
  bool in_view_from_start = false;
};

/// @throws std::invalid_argument showing the value that is out of range.
void validate(const TargetPriorParams& params);

/// What is believed of targets before anything is seen of them: they are spread evenly, in the field of view
/// and around it, and have normal velocities; from that follows how many enter over its border. A few appear
/// inside. It is the birth density of a Poisson multi-Bernoulli filter, [Williams2015].
class TargetPrior {
 public:
  /// @param params validated. @param max_speed of a target [m/s], > 0. @param scan_period [s], > 0.
  explicit TargetPrior(const TargetPriorParams& params = {}, double max_speed = 3.0,
                       double scan_period = 0.5);

  double max_speed() const { return max_speed_; }            ///< Of a target [m/s].
  double velocity_sigma() const { return velocity_sigma_; }  ///< Of each component [m/s].

  /// ln of the density of a velocity over that of standing still, <= 0. @param speed its magnitude [m/s].
  double log_speed(double speed) const;
  /// ln of the factor on the density of a speed [m/s] for the speed limit: 0 up to it, falling beyond it.
  double log_edge(double speed) const;

  /// ln of the density of targets in view of `scan`, over position and velocity, at velocity 0
  /// [1 / (m^2 (m/s)^2)].
  double log_standing(const ScanTable& scan) const;

  /// Mean number of targets that appear inside the field of view at a scan so long after the first [s].
  double appearing(double seconds_since_first) const;
  /// ln of the same over the number of those that are in view already.
  double log_birth(double seconds_since_first) const;

  /// Mean number of targets that enter over the border of the field of view within `seconds`.
  double entering(const ScanTable& scan, double seconds) const;

  /// Mean number of targets in the field of view.
  double expected_targets() const { return params_.expected_targets; }
  /// Replaces the expected number of targets, > 0, as it is learnt.
  void set_expected_targets(double expected);
  /// See TargetPriorParams.
  bool in_view_from_start() const { return params_.in_view_from_start; }

 private:
  TargetPriorParams params_;
  double max_speed_;
  double velocity_sigma_;
  double settling_, settled_;  ///< Targets that appear inside at a scan, while the sonar settles and later.
  double log_settling_, log_settled_;  ///< log_birth of either time.
};

}  // namespace lookout::csht
