#include "tracking/initiation/lines/line_grid.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

LineGrid::LineGrid(int num_theta, int num_rho, double rho_max)
    : num_theta_(num_theta), num_rho_(num_rho), rho_max_(rho_max) {
  core::require(num_theta >= 1, "num_theta must be >= 1", num_theta);
  core::require(num_rho >= 1, "num_rho must be >= 1", num_rho);
  core::require(rho_max > 0.0 && std::isfinite(rho_max), "rho_max must be > 0", rho_max);
  theta_step_ = std::numbers::pi / num_theta;
  rho_step_ = 2.0 * rho_max / num_rho;
}

int LineGrid::row_of(double rho) const {
  return static_cast<int>(std::floor((rho + rho_max_) / rho_step_));
}

LineCell LineGrid::cell_of(const NormalLine& line) const {
  // theta just below pi may round up to the column after the last.
  return wrapped({static_cast<int>(std::floor(line.theta / theta_step_)), row_of(line.rho)});
}

NormalLine LineGrid::centre(const LineCell& cell) const {
  return {(cell.rho + 0.5) * rho_step_ - rho_max_, theta_of(cell.theta)};
}

LineCell LineGrid::wrapped(const LineCell& cell) const {
  LineCell on_grid = cell;
  while (on_grid.theta < 0) on_grid = {on_grid.theta + num_theta_, num_rho_ - 1 - on_grid.rho};
  while (on_grid.theta >= num_theta_) on_grid = {on_grid.theta - num_theta_, num_rho_ - 1 - on_grid.rho};
  return on_grid;
}

LineCell cell_distance(const LineGrid& grid, const LineCell& a, const LineCell& b) {
  const int columns = std::abs(a.theta - b.theta);
  if (2 * columns <= grid.num_theta()) return {columns, std::abs(a.rho - b.rho)};
  return {grid.num_theta() - columns, std::abs(grid.num_rho() - 1 - a.rho - b.rho)};
}

}  // namespace lookout::tracking
