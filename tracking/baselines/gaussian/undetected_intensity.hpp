#pragma once

#include "core/sonar_params.hpp"

namespace lookout::tracking {

/// How many targets there are, how long they stay. Times are in units of the time in which the fastest target
/// crosses the sensor's range, max_range / max_speed.
struct PopulationParams {
  double expected_targets = 2.0;  ///< In the field of view at any time, > 0.
  double stay = 2.0;              ///< Mean time until a target vanishes in view [max_range / max_speed], > 0.
  /// A sonar that starts may not show at once all that is there. For so many scan periods after the first
  /// scan, >= 0,
  double settling_scans = 4.0;
  /// so many more targets come into being in each, >= 0 [expected_targets].
  double settling_share = 0.5;

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// The Poisson process of the targets that exist and were never detected, even over the field of view: births
/// come in at the rate that holds `expected_targets`, and what is in view is detected sooner or later.
/// [Williams2015] with one uniform component.
class UndetectedIntensity {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  UndetectedIntensity(const PopulationParams& params, const core::SonarParams& sonar);

  double survival(double seconds) const;  ///< Probability that a target is still there so much later.
  /// Carries the process so much ahead. @param area of the field of view [m^2].
  void predict(double seconds, double area);
  double density() const { return density_; }  ///< Of the undetected targets [1/m^2].
  /// Takes a scan in: those that were detected are undetected no more.
  void miss(double detection_probability) { density_ *= 1.0 - detection_probability; }

 private:
  PopulationParams params_;
  double stay_s_;               // [s]
  double scan_period_;          // [s]
  double settled_scans_ = 0.0;  // Scan periods since the first scan.
  double density_ = 0.0;
  bool started_ = false;
};

}  // namespace lookout::tracking
