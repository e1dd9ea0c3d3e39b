#include "tracking/track_before_detect/intensity_frame.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace lookout::tracking {
namespace {

[[noreturn]] void refuse_cell(const IntensityFrame& frame, std::size_t cell) {
  const auto columns = static_cast<std::size_t>(frame.columns);
  throw std::invalid_argument("cell (column " + std::to_string(cell % columns) + ", row " +
                              std::to_string(cell / columns) + ") must hold a finite intensity >= 0, got " +
                              std::to_string(frame.values[cell]));
}

/// Whether any of the eight cells from `cell` on is displayed; lets the compiler compare them together.
bool any_displayed(const double* cell, double threshold) {
  bool any = false;
  for (int i = 0; i < 8; ++i) any |= cell[i] > threshold;
  return any;
}

}  // namespace

void check_frame(const IntensityFrame& frame) {
  const auto cells = static_cast<long long>(frame.columns) * frame.rows;
  if (frame.columns < 1 || frame.rows < 1 || static_cast<long long>(frame.values.size()) != cells)
    throw std::invalid_argument("a frame of " + std::to_string(frame.columns) + " x " +
                                std::to_string(frame.rows) + " cells holds " +
                                std::to_string(frame.values.size()) + " values");
  for (std::size_t i = 0; i < frame.values.size(); ++i)
    if (!(std::isfinite(frame.values[i]) && frame.values[i] >= 0.0)) refuse_cell(frame, i);
  if (!(std::isfinite(frame.noise_level) && frame.noise_level > 0.0))
    throw std::invalid_argument("noise_level must be > 0, got " + std::to_string(frame.noise_level));
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double displayed_threshold(double noise_level, double decibels) {
  return noise_level * std::pow(10.0, decibels / 10.0);
}

void collect_displayed(const IntensityFrame& frame, double threshold, const CellWindow& window, int row_step,
                       std::vector<DisplayedCell>& cells) {
  cells.clear();
  for (int row = window.first_row; row < window.last_row; row += row_step) {
    const double* values = frame.values.data() + frame.index(0, row);
    int column = window.first_column;
    while (column < window.last_column) {
      const int end = std::min(column + 8, window.last_column);
      if (end - column == 8 && !any_displayed(values + column, threshold)) {
        column = end;
        continue;
      }
      for (; column < end; ++column)
        if (values[column] > threshold) cells.push_back({column, row, values[column]});
    }
  }
}

}  // namespace lookout::tracking
