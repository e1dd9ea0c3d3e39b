#pragma once

#include <cstdint>
#include <vector>

#include "core/frames.hpp"

namespace lookout::core {

/// One ping as raw intensity, beams x range bins, row-major by beam.
struct SonarImage {
  std::int64_t utime = 0;         ///< Scenario time [us].
  std::int64_t sequence = 0;      ///< Counts images of the sensor.
  std::int32_t sensor_id = 0;     ///< Tells the sonars of one channel apart.
  Pose2 T_body_sonar;             ///< Sonar pose in the body frame (forward, starboard).
  double first_bearing = 0.0;     ///< Centre of beam 0 [rad].
  double bearing_step = 0.0;      ///< Beam spacing [rad], > 0.
  double first_range = 0.0;       ///< Centre of bin 0 [m].
  double range_step = 0.0;        ///< Bin spacing [m], > 0.
  int num_beams = 0;              ///< > 0.
  int num_bins = 0;               ///< Range bins of a beam, > 0.
  std::vector<double> intensity;  ///< num_beams * num_bins values; element beam * num_bins + bin.

  /// Intensity of a bin; 0 <= beam < num_beams, 0 <= bin < num_bins, unchecked.
  double at(int beam, int bin) const {
    return intensity[static_cast<std::size_t>(beam) * static_cast<std::size_t>(num_bins) +
                     static_cast<std::size_t>(bin)];
  }
};

/// An image together with where the sonar was when it was taken.
struct PosedImage {
  SonarImage image;     ///< As it came, in the frame of the sonar.
  Pose2 T_earth_sonar;  ///< Sonar pose in the earth frame at the image's utime.
};

}  // namespace lookout::core
