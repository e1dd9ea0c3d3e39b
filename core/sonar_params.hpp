#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/frames.hpp"
#include "core/uneven_fan.hpp"

namespace lookout::core {

class YamlMap;

/// What is known of the sensor: geometry, accuracy and, where known, its probabilities. These are the keys of
/// a recording's sonar.yaml and of the `sensor:` part of a configuration. Defaults: [Yan2018] Table 1.
struct SonarParams {
  int num_beams = 90;                     ///< >= 1.
  double first_bearing = radians(-44.5);  ///< Centre of beam 0 [rad].
  double bearing_step = radians(1.0);     ///< Beam spacing [rad], > 0; of uneven beams the mean.
  /// Uneven beams, as many as num_beams, the first at first_bearing; null: they are even.
  std::shared_ptr<const UnevenFan> fan = nullptr;
  double max_range = 150.0;             ///< [m], > 0.
  Pose2 T_body_sonar;                   ///< Mount: forward, starboard [m], heading [rad].
  double range_sigma = 3.0;             ///< Standard deviation of a range [m], > 0.
  std::optional<double> bearing_sigma;  ///< [rad], > 0; absent: see `bearing_sigma_or_default`.
  double heading_sigma = 0.0;   ///< Standard deviation of the heading that a scan's pose states [rad], >= 0,
  double position_sigma = 0.0;  ///< and of its north and east [m], >= 0: errors of navigation.
  /// Distance at which two targets give two returns in half of the scans, nearer ones mostly one [m]; >= 0,
  /// 0: each target gives its own return always. Used for sensors without beams.
  double resolution = 0.0;
  double max_speed = 3.0;  ///< Fastest target over ground [m/s], > 0.
  /// How targets' velocities stray: after t seconds each component by this times the root of t, one standard
  /// deviation [m/s per root second], >= 0; 0: targets keep to lines, circles and parabolas. Used by the
  /// joint engine for sensors without beams.
  double wander = 0.0;
  double scan_period = 0.5;  ///< Nominal time between scans [s], > 0.
  /// Age of the returns at the time of their scan [s], in [0, 60]: of a sensor that stamps a scan when it
  /// hands it over. The pose of the scan is that of its time: own motion is the driver's to make up for.
  double latency = 0.0;
  /// Vehicle states farther apart than this do not tell where a scan between them was taken [s], in (0, 600].
  double max_pose_gap = 2.0;
  double max_wait = 1.0;  ///< How long a scan waits for late vehicle states and late scans [s], in [0, 60].
  std::optional<double> miss_probability;         ///< P_M of a target in view, in [0, 1]; absent: estimated.
  std::optional<double> false_alarm_probability;  ///< P_F of an empty beam, in [0, 1]; absent: estimated.
  std::optional<double>
      clutter_per_scan;  ///< Mean of Poisson clutter [1/scan], >= 0; a sensor without beams.

  /// The given bearing sigma, or that of a uniform error over one beam, step / sqrt(12) [rad].
  double bearing_sigma_or_default() const;
  /// Of a beam [rad]: of uneven beams that of one of the mean width, in proportion to the beam's own.
  double bearing_sigma_at(int beam) const;
  /// Width of a beam [rad].
  double beam_width(int beam) const { return fan ? fan->width(beam) : bearing_step; }
  /// Between the sector's edges [rad].
  double sector() const { return fan ? fan->sector() : num_beams * bearing_step; }
  /// Whether false alarms are points of a Poisson law (any number of returns) rather than one return a beam.
  bool point_sensor() const { return clutter_per_scan.has_value(); }
  /// Bearings [rad] of the sector's two edges, half a step outside the outer beams' centres.
  double left_edge() const { return fan ? fan->left_edge() : first_bearing - 0.5 * bearing_step; }
  /// Bearing of the sector's right edge [rad].
  double right_edge() const { return fan ? fan->right_edge() : left_edge() + num_beams * bearing_step; }
  /// Where a bearing [rad] lies, in beams from the sector's left edge: .5 is the centre of beam 0.
  double place_of(double bearing) const;
  /// The beam whose centre is nearest to `bearing`, or -1 outside the sector.
  int beam_of(double bearing) const;
  /// Centre of a beam [rad].
  double beam_centre(int beam) const { return fan ? fan->centre(beam) : first_bearing + beam * bearing_step; }
};

/// Overrides `params` with the keys that `map` holds, and calls map.finish().
/// @throws InputError on an unknown key, a value out of range, or clutter given in both ways.
void read_sonar_params(const YamlMap& map, SonarParams& params);

/// The same from a file.
void read_sonar_params(const std::string& path, SonarParams& params);

/// The params as the text of a sonar.yaml that `read_sonar_params` reads back to the same values.
std::string to_yaml(const SonarParams& params);

}  // namespace lookout::core
