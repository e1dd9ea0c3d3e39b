#pragma once

#include "core/sonar_params.hpp"
#include "csht/count_decision.hpp"
#include "csht/hough_space.hpp"
#include "csht/line_classes.hpp"
#include "csht/refit.hpp"
#include "csht/single_line.hpp"
#include "csht/spatial_correlation.hpp"

namespace lookout::csht {

/// All parameters of the faithful estimator. Two documented sets; neither is changed per cell of a table. How
/// each value was found: docs/csht.md.
struct CshtParams {
  int window_scans = 20;         ///< W, 3 to kMaxWindowScans. [Yan2018] section V.
  int first_estimate_scans = 3;  ///< Scans before the first estimate, 1 to window_scans.
  bool both_axes = true;  ///< East takes its turn as first axis too; false: north alone, as in the paper.
  int passes = 3;         ///< Most searches, each among the detections without an owner, > 0.
  double intercept_step = 0.5;   ///< Of the grid, in the range sigma, > 0.
  double velocity_step = 0.7;    ///< Of the grid, in range sigma / half the window's duration, > 0.
  double cross_floor = 0.2;      ///< Added to the error across the line of sight [m], >= 0.
  double top_speed = 4.0 / 3.0;  ///< Fastest fit, in the sensor's max_speed (the limit of one axis), > 0.
  double speed_prior = 0.0;  ///< Standard deviation of a target's velocity on each axis before any detection,
                             ///< in the sensor's max_speed; 0: no prior in the fit.
  VoteParams votes;
  LineClassesParams classes;             ///< How cells become classes of lines.
  SpatialCorrelationParams correlation;  ///< Which north and east lines belong together.
  SingleLineParams single_line;          ///< Which classes are one line.
  RefitParams refit;  ///< Its max_speed comes from `top_speed`, its velocity_sigma from `speed_prior`.
  CountDecisionParams decision;  ///< Its prior_speed and velocity_sigma likewise.

  /// One full window in which every target is present: the set of the window tables.
  static CshtParams window() { return {}; }
  /// A stream in which targets come and go, and confirmed tracks are offered back.
  static CshtParams tracking();
};

/// The grid whose steps follow the sensor's accuracy and whose rows reach its max_speed.
/// @throws std::invalid_argument where that takes more memory than a vehicle computer has.
HoughGrid csht_grid(const CshtParams& params, const core::SonarParams& sonar);

/// Largest standard deviation of a detection along an axis [m], at the sonar's range limit.
double largest_axis_sigma(const core::SonarParams& sonar);

}  // namespace lookout::csht
