#include "csht/csht_params.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

constexpr double kMostCells = 16e6;  // Seven spaces of them are kept: half a gigabyte.

}  // namespace

CshtParams CshtParams::tracking() {
  CshtParams params;
  params.intercept_step = 0.7;
  params.speed_prior = 0.5;       // a velocity spread evenly over the disc of max_speed has this deviation
  params.classes.max_first = 12;  // tracks are offered back: more classes cost time and gain nothing
  params.classes.threshold.floor = 2.0;
  params.classes.threshold.mean_root = 1.0;
  params.correlation.max_lines = 3;
  params.refit.gate = 9.0;
  params.decision.min_evidence = 4.0;
  params.decision.relative_support = 0.0;
  params.decision.clutter_regulariser = 2.0;
  return params;
}

HoughGrid csht_grid(const CshtParams& params, const core::SonarParams& sonar) {
  const double half_window = 0.5 * (params.window_scans - 1) * sonar.scan_period;
  HoughGrid grid;
  grid.velocity_step = params.velocity_step * sonar.range_sigma / half_window;
  grid.intercept_step = params.intercept_step * sonar.range_sigma;
  grid.max_speed = sonar.max_speed;
  // The sonar sees max_range to either side, votes drift on to the epoch, and the vehicle moves meanwhile.
  grid.extent = 2.0 * sonar.max_range + 4.0 * sonar.max_speed * half_window;
  const double cells = 2.0 * grid.max_speed / grid.velocity_step * grid.extent / grid.intercept_step;
  core::require(
      cells <= kMostCells,
      "max_range, max_speed and scan_period over range_sigma must leave csht a vote space of at most "
      "16e6 cells",
      cells);
  return grid;
}

double largest_axis_sigma(const core::SonarParams& sonar) {
  return std::max(sonar.range_sigma, sonar.max_range * sonar.bearing_sigma_or_default());
}

}  // namespace lookout::csht
