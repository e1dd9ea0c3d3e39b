#include "csht/likelihood/clutter/clutter_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lookout::csht {
namespace {

constexpr int kMostBearings = 60;
constexpr int kRanges = 50;
constexpr std::size_t kMostReturns = 1000;  // That are priced, in either frame.

std::size_t cell_at(const core::ClutterGrid& grid, int row, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.num_ranges) +
         static_cast<std::size_t>(column);
}

core::ClutterGrid empty_grid(const ScanTable& newest) {
  core::ClutterGrid grid;
  grid.utime = newest.utime;
  grid.T_earth_sonar = newest.T_earth_sonar;
  grid.first_bearing = newest.first_bearing - 0.5 * newest.bearing_step;
  grid.num_bearings = std::clamp(newest.num_beams, 1, kMostBearings);
  grid.bearing_step = newest.num_beams * newest.bearing_step / grid.num_bearings;
  grid.num_ranges = kRanges;
  grid.range_step = newest.max_range / kRanges;
  grid.density.assign(cell_at(grid, grid.num_bearings, 0), 0);
  return grid;
}

std::int8_t decibels(double background) {
  constexpr double kBel = 10.0, kMost = std::numeric_limits<std::int8_t>::max();
  return static_cast<std::int8_t>(std::clamp(std::round(-kBel * std::log10(background)), 0.0, kMost));
}

/// Share of the fan's bearings to port of a place that many beams from its middle: the cells are even.
double bearing_share(double beam, const ScanTable& scan) {
  if (!scan.uneven()) return beam / scan.num_beams + 0.5;
  const double from_edge = scan.bearing_of_beams(beam) + 0.5 * scan.num_beams * scan.bearing_step;
  return from_edge / (scan.num_beams * scan.bearing_step);
}

int cell_of(double share, int cells) {
  return std::clamp(static_cast<int>(share * cells), 0, cells - 1);
}

}  // namespace

core::ClutterGrid clutter_grid(const ClutterMap& map, const ScanTable& newest, double rate) {
  core::ClutterGrid grid = empty_grid(newest);
  for (const auto& [beam, range, background] : map.places(newest, rate, kMostReturns)) {
    const int row = cell_of(bearing_share(beam, newest), grid.num_bearings);
    const int column = cell_of(range / newest.max_range, grid.num_ranges);
    std::int8_t& cell = grid.density[cell_at(grid, row, column)];
    cell = std::max(cell, decibels(background));
  }
  return grid;
}

}  // namespace lookout::csht
