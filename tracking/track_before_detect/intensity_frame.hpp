#pragma once

#include <cstddef>
#include <vector>

namespace lookout::tracking {

/// One image of non-negative intensities. Cell (column, row) covers [column, column + 1) x [row, row + 1), so
/// that its centre lies at .5.
struct IntensityFrame {
  int columns = 0;             ///< Cells of a row, > 0.
  int rows = 0;                ///< Cells of a column, > 0.
  std::vector<double> values;  ///< columns * rows intensities; element row * columns + column.
  double noise_level = 1.0;    ///< What the empty cells hold typically, > 0.

  /// Where a cell stands in `values`; unchecked.
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// Intensity of a cell; unchecked.
  double at(int column, int row) const { return values[index(column, row)]; }
};

/// Median of the values (of a copy); 0 of none.
double median_of(std::vector<double> values);

/// Displayed-cell threshold: the noise level raised by `decibels` (10 log10). [Pakfiliz2018] section on DCT.
double displayed_threshold(double noise_level, double decibels);

/// The cells above the displayed-cell threshold.
struct DisplayedCell {
  int column = 0;          ///< Of the cell.
  int row = 0;             ///< Of the cell.
  double intensity = 0.0;  ///< The whole of it, above the threshold.
};

/// The cells [first_column, last_column) x [first_row, last_row).
struct CellWindow {
  int first_column = 0, last_column = 0;  ///< [cells]; the last is not in it.
  int first_row = 0, last_row = 0;        ///< [cells]; the last is not in it.
  /// Whether a cell lies in it.
  bool contains(int column, int row) const {
    return column >= first_column && column < last_column && row >= first_row && row < last_row;
  }
  int columns() const { return last_column - first_column; }  ///< Width [cells].
  int rows() const { return last_row - first_row; }           ///< Height [cells].
};
/// @throws std::invalid_argument where the size disagrees with the values or the noise level is not positive.
void check_frame_shape(const IntensityFrame& frame);
/// @throws std::invalid_argument naming the first cell of the window (every `row_step`-th row of it) whose
/// value is negative or not finite.
void check_cells(const IntensityFrame& frame, const CellWindow& window, int row_step);
/// Both, of all cells.
void check_frame(const IntensityFrame& frame);

/// Overwrites `cells` with the displayed cells of the window, in row order; every `row_step`-th row alone.
void collect_displayed(const IntensityFrame& frame, double threshold, const CellWindow& window, int row_step,
                       std::vector<DisplayedCell>& cells);

}  // namespace lookout::tracking
