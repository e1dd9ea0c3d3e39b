#pragma once

#include <algorithm>

#include "core/sonar_params.hpp"
#include "csht/joint/density/engine_params.hpp"

namespace lookout::csht {

/// The units that a sensor sets, as multiples of those of the sonar that the engine's parameters are stated
/// for
/// ([Yan2018] Table 1: range sigma 3 m, targets of up to 3 m/s, half a second a scan): a parameter of 4 m
/// means 4/3 range sigmas, one of 10 s means ten times what the fastest target takes for a range sigma.
struct SensorScale {
  double length = 1.0;       ///< Of the sensor's error of position.
  double speed = 1.0;        ///< Of the fastest target's speed.
  double scan_period = 0.5;  ///< [s].

  static constexpr double kLeastTime = 0.01, kMostTime = 20.0;  ///< No sensor is beyond.

  double time() const { return std::clamp(length / speed, kLeastTime, kMostTime); }  ///< Of times.
  double acceleration() const { return speed / time(); }                             ///< Of accelerations.
  /// A time of `seconds` [s] for the reference sonar, but no less than so many scans [s].
  double seconds(double seconds, double least_scans) const;

  /// The scale of a sensor. Its error of position is its range sigma or, where that is larger, the error of
  /// its bearing at half its range.
  static SensorScale of(const core::SonarParams& sonar);
};

/// The parameters of the engine for a sensor of this scale.
JointEngineParams scaled(const JointEngineParams& params, const SensorScale& scale);

}  // namespace lookout::csht
