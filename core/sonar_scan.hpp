#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/frames.hpp"

namespace lookout::core {

class UnevenFan;

/// One return of a scan, in the sonar frame.
struct SonarReturn {
  double bearing = 0.0;    ///< [rad], positive to starboard of the sonar axis.
  double range = 0.0;      ///< [m], in (0, max_range].
  double intensity = 1.0;  ///< Of the sensor's own unit.
};

/// One ping of a multi-beam sonar (or one turn of any point sensor): what it returned and the geometry it
/// holds in.
struct SonarScan {
  std::int64_t utime = 0;      ///< Scenario time [us].
  std::int64_t sequence = 0;   ///< Counts scans of the sensor.
  std::int32_t sensor_id = 0;  ///< Tells the sonars of one channel apart.
  Pose2 T_body_sonar;          ///< Sonar pose in the body frame (forward, starboard).
  double first_bearing = 0.0;  ///< Centre of beam 0 [rad].
  double bearing_step = 0.0;   ///< Beam spacing [rad], > 0; of uneven beams the mean.
  double max_range = 0.0;      ///< [m], > 0.
  int num_beams = 0;           ///< > 0.
  /// Where the beams are uneven, as many as num_beams; null: they are even. No message carries it: the intake
  /// knows it from the configuration or finds it.
  std::shared_ptr<const UnevenFan> fan = nullptr;
  std::vector<SonarReturn> returns;  ///< In any order; a beam may have none or, of point sensors, several.
};

/// A scan together with where the sonar was when it was taken.
struct PosedScan {
  SonarScan scan;       ///< As it came, in the frame of the sonar.
  Pose2 T_earth_sonar;  ///< Sonar pose in the earth frame at the scan's utime.
};

}  // namespace lookout::core
