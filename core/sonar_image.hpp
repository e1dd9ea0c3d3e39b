#pragma once

#include <cstdint>
#include <vector>

#include "core/frames.hpp"

namespace lookout::core {

/// One ping as raw intensity, beams x range bins, row-major by beam.
struct SonarImage {
  std::int64_t utime = 0;        ///< Scenario time [us].
  std::int64_t sequence = 0;     ///< Counts images of the sensor.
  std::int32_t sensor_id = 0;    ///< Tells the sonars of one channel apart.
  Pose2 T_body_sonar;            ///< Sonar pose in the body frame (forward, starboard).
  std::vector<double> bearings;  ///< Centre of each beam [rad], a table as of core/beam_bearings.hpp.
  double first_range = 0.0;      ///< Centre of bin 0 [m].
  double range_step = 0.0;       ///< Bin spacing [m], > 0.
  /// Sensor units of one integer step, where the intensities are whole multiples of it; 0: they are not.
  double intensity_scale = 0.0;
  int num_bins = 0;               ///< Range bins of a beam, > 0.
  std::vector<double> intensity;  ///< num_beams() * num_bins values; element beam * num_bins + bin.

  /// Beams of the table.
  int num_beams() const { return static_cast<int>(bearings.size()); }
  /// Intensity of a bin; 0 <= beam < num_beams(), 0 <= bin < num_bins, unchecked.
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

/// Largest magnitude of the intensities; 0 of none.
double largest_magnitude(const SonarImage& image);

/// Rounds the intensities to whole steps as an instrument delivers them, so that message and file hold them
/// to the bit: `intensity_scale` becomes the largest magnitude / `levels` (1 of a dark image).
/// @param levels steps of the largest magnitude, >= 1.
void quantise(SonarImage& image, double levels);

/// Sets the beams in the order from port where the table falls, rows included. A table that does neither is
/// left.
void count_from_port(SonarImage& image);

}  // namespace lookout::core
