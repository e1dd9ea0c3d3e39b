// The clutter map, for people's eyes.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "lcmtypes/convert.hpp"
#include "lcmtypes/wire_checks.hpp"

namespace lookout::lcmtypes {
namespace {

bool is_grid(const clutter_map_t& wire) {
  const auto is_full = [&wire](const auto& row) { return agrees(wire.num_ranges, row.size()); };
  return wire.num_bearings > 0 && wire.num_ranges > 0 && agrees(wire.num_bearings, wire.density.size()) &&
         std::all_of(wire.density.begin(), wire.density.end(), is_full);
}

std::size_t num_cells(int num_bearings, int num_ranges) {
  return static_cast<std::size_t>(num_bearings) * static_cast<std::size_t>(num_ranges);
}

bool has_density_below_0(const clutter_map_t& wire) {
  const auto is_below_0 = [](std::int8_t value) { return value < 0; };
  return std::any_of(wire.density.begin(), wire.density.end(),
                     [&](const auto& row) { return std::any_of(row.begin(), row.end(), is_below_0); });
}

}  // namespace

Converted<core::ClutterGrid> to_core(const clutter_map_t& wire) {
  if (!is_time(wire.utime)) return {{}, "clutter map: time out of range"};
  if (!is_grid(wire)) return {{}, "clutter map: number disagrees with the cells"};
  if (num_cells(wire.num_bearings, wire.num_ranges) > kMaxClutterCells)
    return {{}, "clutter map: too many cells"};
  if (!all_finite({wire.sonar_north, wire.sonar_east, wire.sonar_heading, wire.first_bearing,
                   wire.bearing_step, wire.range_step}))
    return {{}, "clutter map: not finite"};
  if (!(wire.bearing_step > 0.0 && wire.range_step > 0.0)) return {{}, "clutter map: a step is not above 0"};
  if (has_density_below_0(wire)) return {{}, "clutter map: a density is below 0"};
  core::ClutterGrid grid;
  grid.utime = wire.utime;
  grid.sensor_id = wire.sensor_id;
  grid.T_earth_sonar = {wire.sonar_north, wire.sonar_east, wire.sonar_heading};
  grid.first_bearing = wire.first_bearing;
  grid.bearing_step = wire.bearing_step;
  grid.range_step = wire.range_step;
  grid.num_bearings = wire.num_bearings;
  grid.num_ranges = wire.num_ranges;
  for (const auto& row : wire.density) grid.density.insert(grid.density.end(), row.begin(), row.end());
  return {std::move(grid), {}};
}

clutter_map_t to_wire(const core::ClutterGrid& grid) {
  const std::size_t cells = num_cells(grid.num_bearings, grid.num_ranges);
  if (cells > kMaxClutterCells || cells != grid.density.size())
    throw std::length_error("clutter map: " + std::to_string(cells) + " cells with " +
                            std::to_string(grid.density.size()) +
                            " densities, expected one each and at most " + std::to_string(kMaxClutterCells));
  clutter_map_t wire{};
  wire.utime = grid.utime;
  wire.sensor_id = grid.sensor_id;
  wire.sonar_north = grid.T_earth_sonar.north;
  wire.sonar_east = grid.T_earth_sonar.east;
  wire.sonar_heading = grid.T_earth_sonar.heading;
  wire.first_bearing = grid.first_bearing;
  wire.bearing_step = grid.bearing_step;
  wire.range_step = grid.range_step;
  wire.num_bearings = static_cast<std::int16_t>(grid.num_bearings);
  wire.num_ranges = static_cast<std::int16_t>(grid.num_ranges);
  for (auto row = grid.density.begin(); row != grid.density.end(); row += grid.num_ranges)
    wire.density.emplace_back(row, row + grid.num_ranges);
  return wire;
}

}  // namespace lookout::lcmtypes
