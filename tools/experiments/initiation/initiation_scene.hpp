#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "tracking/initiation/lines/line_geometry.hpp"
#include "tracking/initiation/plots/plot_window.hpp"

/// The scenes on which track initiators are compared; one generator for all methods.
namespace lookout::tools {

/// The scans of one run, and what is true of them.
struct InitiationScene {
  std::vector<std::vector<tracking::Plot>> scans;  ///< `source` numbers the plots of the run from 0.
  std::vector<double> times;                       ///< [s].
  std::vector<int> target_of;                      ///< Of each source: its target, or -1 for clutter.
  int num_targets = 0;
  std::vector<Eigen::Vector2d> centres;     ///< Middle of each target's true course [m].
  std::vector<Eigen::Vector2d> directions;  ///< Unit vector of each target's true course.

  /// All scans as one window.
  tracking::PlotWindow window() const;
};

/// [Fan2018] section V.A: three targets, seven scans of 2 s.
struct FanSceneParams {
  std::string situation = "IV";      ///< I ideal, II noise, III clutter, IV both.
  std::string noise = "consistent";  ///< consistent: 1 m, no process noise; printed: 10 m and 10 m/s a step.
  double clutter_per_scan = 10.0;    ///< Mean of a Poisson number in x 0..4000, y 0..1600 m.
  bool printed_signs =
      false;  ///< Target 2 with vy = -100 as printed: it then crosses nothing (docs/initiators.md).
  double detection_probability = 1.0;  ///< Of a target in a scan, in (0, 1]; .99 in section V.A.
};
/// Standard deviation of a plot along each axis that these params simulate [m]; the figure a sensor would
/// state.
double plot_sigma(const FanSceneParams& params);
/// Acceleration over a step that the printed process noise amounts to [m/s^2].
double acceleration_sigma(const FanSceneParams& params);
InitiationScene fan_scene(const FanSceneParams& params, core::Random& random);

/// [Fan2018] Table 3: three real radar tracks (tools/data/fan2018_table3.csv) with seeded clutter in x
/// -25..0, y 12..30 km.
InitiationScene real_scene(double clutter_per_scan, double position_sigma, core::Random& random);

/// [Zeng2023] section 3.1: five targets, a radar at the origin of a square of 100 km, scans of 5 s.
struct ZengSceneParams {
  int num_scans = 4;
  double clutter_per_scan = 120.0;  ///< Mean of a Poisson number in the whole square.
  double detection_probability = 1.0;
  double range_sigma = 10.0;                              ///< [m].
  double azimuth_sigma = 0.3 * 3.14159265358979 / 180.0;  ///< [rad].
  /// Beyond the paper: a steady turn [rad/s], of every other target to the other hand; a steady acceleration
  /// along the course [m/s^2]; what the method is told of the errors, as a multiple of what they are; and
  /// clutter in clusters of five, two kilometres wide, as many plots in the mean.
  double turn_rate = 0.0;
  double acceleration = 0.0;
  double told_noise = 1.0;
  bool clustered = false;
};
InitiationScene zeng_scene(const ZengSceneParams& params, core::Random& random);

}  // namespace lookout::tools
