#pragma once

#include <cstdint>

#include "tracking/initiation/lines/line_geometry.hpp"

namespace lookout::tracking {

/// Indices of a cell of a line grid.
struct LineCell {
  int theta = 0;  ///< Column, 0 .. num_theta - 1 where it lies on the grid.
  int rho = 0;    ///< Row, 0 .. num_rho - 1 where it lies on the grid.
  bool operator==(const LineCell&) const = default;
};

/// A grid over lines: theta over [0, pi), rho over [-rho_max, rho_max], both with signed rho and wrapped
/// theta. The centre of cell (i, j) is ((j + 1/2) rho_step - rho_max, (i + 1/2) theta_step): corrects
/// [Fan2018] Eq. (25) and [Zeng2023] Eq. (12), which leave out every line with negative rho.
class LineGrid {
 public:
  /// @param rho_max half of the covered rho [m], > 0.
  /// @throws std::invalid_argument on a value out of range.
  LineGrid(int num_theta, int num_rho, double rho_max);

  int num_theta() const { return num_theta_; }       ///< Columns.
  int num_rho() const { return num_rho_; }           ///< Rows.
  double theta_step() const { return theta_step_; }  ///< [rad].
  double rho_step() const { return rho_step_; }      ///< [m].
  double rho_max() const { return rho_max_; }        ///< [m].

  /// The cell of a line with theta in [0, pi); its row may lie off the grid (see `contains`).
  LineCell cell_of(const NormalLine& line) const;
  NormalLine centre(const LineCell& cell) const;  ///< The line through the middle of a cell.
  double theta_of(int column) const { return (column + 0.5) * theta_step_; }  ///< [rad].
  int row_of(double rho) const;                                               ///< May lie off the grid.

  /// The same cell with its column on the grid: a step over either end of theta mirrors the row.
  LineCell wrapped(const LineCell& cell) const;
  /// Whether the cell lies on the grid.
  bool contains(const LineCell& cell) const {
    return cell.theta >= 0 && cell.theta < num_theta_ && cell.rho >= 0 && cell.rho < num_rho_;
  }

  /// A number of its own for each cell on the grid, and back.
  std::int64_t index(const LineCell& cell) const {
    return static_cast<std::int64_t>(cell.theta) * num_rho_ + cell.rho;
  }
  /// The cell of a number from `index`.
  LineCell cell_at(std::int64_t index) const {
    return {static_cast<int>(index / num_rho_), static_cast<int>(index % num_rho_)};
  }
  /// Cells of the grid.
  std::int64_t num_cells() const { return static_cast<std::int64_t>(num_theta_) * num_rho_; }

 private:
  int num_theta_;
  int num_rho_;
  double rho_max_;
  double theta_step_;
  double rho_step_;
};

/// How many columns and rows apart two cells lie, over the wrap where that is nearer.
LineCell cell_distance(const LineGrid& grid, const LineCell& a, const LineCell& b);

}  // namespace lookout::tracking
