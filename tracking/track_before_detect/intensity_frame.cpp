#include "tracking/track_before_detect/intensity_frame.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

[[noreturn]] void refuse_cell(const IntensityFrame& frame, std::size_t cell) {
  const auto columns = static_cast<std::size_t>(frame.columns);
  throw std::invalid_argument("cell (column " + std::to_string(cell % columns) + ", row " +
                              std::to_string(cell / columns) + ") must hold a finite intensity >= 0, got " +
                              std::to_string(frame.values[cell]));
}

constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;
constexpr std::uint64_t kLeastExponent = std::uint64_t{1} << 52;

bool usable(double value) {
  return value >= 0.0 && value <= std::numeric_limits<double>::max();  // NaN is neither.
}

/// Whether all values are usable, by their bits, which the compiler compares many at a time: a sign bit marks
/// the negative, and one more unit of exponent carries into it from infinity and NaN. False of -0 too.
bool surely_usable(const double* values, std::size_t count) {
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = std::bit_cast<std::uint64_t>(values[i]);
    seen |= bits | (bits + kLeastExponent);
  }
  return (seen & kSignBit) == 0;
}

/// Whether any of the eight cells from `cell` on is displayed: the difference is negative.
bool any_displayed(const double* cell, double threshold) {
  std::uint64_t seen = 0;
  for (int i = 0; i < 8; ++i) seen |= std::bit_cast<std::uint64_t>(threshold - cell[i]);
  return (seen & kSignBit) != 0;
}

}  // namespace

void check_frame_shape(const IntensityFrame& frame) {
  const auto cells = static_cast<long long>(frame.columns) * frame.rows;
  if (frame.columns < 1 || frame.rows < 1 || static_cast<long long>(frame.values.size()) != cells)
    throw std::invalid_argument("a frame of " + std::to_string(frame.columns) + " x " +
                                std::to_string(frame.rows) + " cells holds " +
                                std::to_string(frame.values.size()) + " values");
  core::require(std::isfinite(frame.noise_level) && frame.noise_level > 0.0, "noise_level must be > 0",
                frame.noise_level);
}

void check_cells(const IntensityFrame& frame, const CellWindow& window, int row_step) {
  for (int row = window.first_row; row < window.last_row; row += row_step) {
    const std::size_t first = frame.index(window.first_column, row);
    const double* values = frame.values.data() + first;
    const auto columns = static_cast<std::size_t>(window.columns());
    if (surely_usable(values, columns)) continue;
    const double* bad = std::find_if_not(values, values + columns, usable);
    if (bad != values + columns) refuse_cell(frame, first + static_cast<std::size_t>(bad - values));
  }
}

void check_frame(const IntensityFrame& frame) {
  check_frame_shape(frame);
  check_cells(frame, {0, frame.columns, 0, frame.rows}, 1);
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
