#include "tools/experiments/tracking/clutter_picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/files/csv.hpp"
#include "core/frames.hpp"
#include "core/random.hpp"
#include "sonar_sim/random_streams.hpp"
#include "sonar_sim/sea/standing_things.hpp"
#include "sonar_sim/sonar_simulator.hpp"

namespace lookout::tools {
namespace {

constexpr int kRuns = 2500, kScans = 4;  // In which the vehicle goes 1.2 m: less than a cell is deep.
/// Keeps the draws of these scans apart from all others.
constexpr std::uint64_t kCountingDraws = std::uint64_t{1} << 41;

/// The last scans of the run, without targets.
sonar_sim::Scene last_scans(sonar_sim::Scene scene, std::uint64_t seed, int run) {
  scene.targets.clear();
  sonar_sim::SonarPlan& sonar = scene.platforms.front().sonar;
  core::Random places = sonar_sim::open_stream({.seed = seed, .run = static_cast<std::uint64_t>(run)},
                                               sonar_sim::StreamPurpose::places);
  sonar.sea.standing = sonar_sim::place_fields(std::move(sonar.sea.standing), places);
  const double period = sonar.params.scan_period;
  const double scans = std::ceil((scene.duration - sonar.first_scan) / period);
  sonar.first_scan += period * std::max(0.0, scans - kScans);
  return scene;
}

struct Cell {
  int row = 0, column = 0;
};

Cell cell_of(const core::SonarReturn& heard, const core::ClutterGrid& grid) {
  const auto row = static_cast<int>((heard.bearing - grid.first_bearing) / grid.bearing_step);
  const auto column = static_cast<int>(heard.range / grid.range_step);
  return {std::clamp(row, 0, grid.num_bearings - 1), std::clamp(column, 0, grid.num_ranges - 1)};
}

std::size_t index_of(const Cell& cell, const core::ClutterGrid& grid) {
  return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(grid.num_ranges) +
         static_cast<std::size_t>(cell.column);
}

/// How many returns the background makes in a cell of each row, in one scan.
std::vector<double> background_of(const core::SonarParams& sonar, const core::ClutterGrid& grid) {
  std::vector<double> expected(static_cast<std::size_t>(grid.num_bearings), 0.0);
  const double in_beam = *sonar.false_alarm_probability * grid.range_step / sonar.max_range;
  for (int beam = 0; beam < sonar.num_beams; ++beam)
    expected[static_cast<std::size_t>(cell_of({sonar.beam_centre(beam), 0.0}, grid).row)] += in_beam;
  return expected;
}

}  // namespace

std::vector<double> true_clutter(const sonar_sim::Scene& scene, std::uint64_t seed, int run,
                                 const core::ClutterGrid& like) {
  const sonar_sim::Scene counted = last_scans(scene, seed, run);
  const std::uint64_t draws =
      core::Random(seed, core::RandomStream::experiment, kCountingDraws | static_cast<std::uint64_t>(run))();
  std::vector<double> density(like.density.size(), 0.0);
  for (int k = 0; k < kRuns; ++k) {
    sonar_sim::SonarSimulator simulator(counted, draws, static_cast<std::uint64_t>(k));
    while (const auto simulated = simulator.next())
      for (const core::SonarReturn& heard : simulated->scan.returns)
        density[index_of(cell_of(heard, like), like)] += 1.0;
  }
  const auto background = background_of(scene.platforms.front().sonar.params, like);
  for (std::size_t cell = 0; cell < density.size(); ++cell) {
    const double expected = background[cell / static_cast<std::size_t>(like.num_ranges)] * kRuns * kScans;
    density[cell] = 10.0 * std::log10(density[cell] / expected);
  }
  return density;
}

void write_clutter(const std::vector<double>& truth, const std::vector<LearntClutter>& learnt,
                   const std::string& path) {
  std::string header = "bearing_deg,range_m,true_db";
  for (const auto& [method, grid] : learnt) header += "," + method + "_db";
  core::CsvWriter csv(path, header);
  const core::ClutterGrid& grid = learnt.front().grid;
  for (std::size_t cell = 0; cell < truth.size(); ++cell) {
    const std::size_t num_ranges = static_cast<std::size_t>(grid.num_ranges);
    const std::size_t row = cell / num_ranges, column = cell % num_ranges;
    csv.number(core::degrees(grid.first_bearing + (static_cast<double>(row) + 0.5) * grid.bearing_step));
    csv.number((static_cast<double>(column) + 0.5) * grid.range_step);
    std::isfinite(truth[cell]) ? csv.number(truth[cell]) : csv.blank();
    for (const LearntClutter& one : learnt) csv.number(static_cast<double>(one.grid.density[cell]));
    csv.end_row();
  }
  csv.close();
}

}  // namespace lookout::tools
