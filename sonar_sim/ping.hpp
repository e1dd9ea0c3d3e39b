#pragma once

#include <cstdint>
#include <optional>

#include "core/frames.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"

namespace lookout::sonar_sim {

/// How false alarms are drawn; docs/symbols.md has both in formulas.
enum class ClutterReading {
  literal,  ///< Each beam without a target alarms with P_F.
  light     ///< A Poisson number, in proportion to the expected detections, in beams without a target.
};

/// What holds while the echoes of one ping come back.
struct Ping {
  core::SonarParams params;       ///< With the range setting and the false alarms of its time.
  core::Pose2 T_earth_sonar;      ///< True pose.
  double echo_range_sigma = 3.0;  ///< Of an echo's range [m].
  bool quantise_bearing = true;   ///< Report an echo at its beam's centre; off: at its own bearing.
  /// How false alarms are drawn.
  ClutterReading clutter = ClutterReading::literal;
  int returns_per_beam = 1;  ///< Most returns of one beam, >= 1. Not used for point sensors.

  /// Whether a range [m] lies within (0, max_range].
  bool in_range(double range) const { return range > 0.0 && range <= params.max_range; }
  /// The bearing that a return of a beam states [rad].
  double reported_bearing(int beam, double bearing) const {
    return quantise_bearing && !params.point_sensor() ? params.beam_centre(beam) : bearing;
  }
};

/// What a return comes from, in order of precedence.
enum class Source { target, standing, spill, clutter, background };

/// One return before the sonar chooses which it reports.
struct BeamReturn {
  /// Index of the beam.
  int beam = 0;
  /// Range, bearing and intensity, as reported.
  core::SonarReturn measured;
  /// What made it.
  Source source = Source::background;
  int thing = 0;  ///< Echoes of one thing share it: target >= 0, standing thing < 0.
  std::optional<double> snr_db =
      std::nullopt;      ///< Mean power of the thing's echo over the clutter's; absent: the sea's.
  double loss_db = 0.0;  ///< Of an echo that is heard beside its beam.
};

}  // namespace lookout::sonar_sim
