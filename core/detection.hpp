#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace lookout::core {

/// One sonar return placed in the earth frame.
struct Detection {
  std::int64_t utime = 0;               ///< Of its scan [us].
  int scan = 0;                         ///< Index of its scan in the window, 0 the oldest.
  int beam = 0;                         ///< Index of the beam whose centre is nearest to its bearing.
  double range = 0.0;                   ///< [m], in the sonar frame.
  double bearing = 0.0;                 ///< [rad], in the sonar frame.
  double intensity = 1.0;               ///< Of the sensor's own unit.
  double azimuth = 0.0;                 ///< Direction from the sonar, clockwise from north [rad].
  Eigen::Vector2d p_earth{0, 0};        ///< North, east [m].
  Eigen::Vector2d p_earth_sonar{0, 0};  ///< Where the sonar was: north, east [m].
};

}  // namespace lookout::core
