#pragma once

#include <cstdint>
#include <vector>

#include "core/frames.hpp"

namespace lookout::core {

/// What a tracker has learnt of its clutter, cut into cells of bearing and range around one place of the
/// sonar: for people's eyes. docs/clutter_map.md.
struct ClutterGrid {
  std::int64_t utime = 0;      ///< Of the newest scan that it rests on [us].
  std::int32_t sensor_id = 0;  ///< Of that scan.
  Pose2 T_earth_sonar;         ///< Where the sonar was then.
  double first_bearing = 0.0;  ///< Port edge of the first cells, in the sonar frame [rad].
  double bearing_step = 0.0;   ///< Width of a cell [rad], > 0.
  double range_step = 0.0;     ///< Depth of a cell [m], > 0; the first begins at the sonar.
  int num_bearings = 0;        ///< >= 1.
  int num_ranges = 0;          ///< >= 1.
  /// By bearing, then range: density of false returns where they are densest in a cell, over that of the
  /// uniform background [dB], 0 to 127; 0 where nothing but the background is known.
  std::vector<std::int8_t> density;
};

}  // namespace lookout::core
