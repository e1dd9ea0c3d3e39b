#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/clutter_grid.hpp"
#include "sonar_sim/scene.hpp"

namespace lookout::tools {

/// Density of the false returns of a scene around the sonar at the last scan of one of its runs, counted over
/// ten thousand independent scans without targets in which what stands lies where it does in that run. One
/// sonar, beams of one width. @param like gives the cells.
/// @return by bearing, then range, over the density of the uniform background [dB]; minus infinity where
/// nothing came.
std::vector<double> true_clutter(const sonar_sim::Scene& scene, std::uint64_t seed, int run,
                                 const core::ClutterGrid& like);

/// What a tracker had learnt at the end of a run.
struct LearntClutter {
  std::string method;  ///< Of the tracker.
  core::ClutterGrid grid;
};

/// Writes a row a cell: bearing and range of its middle, the true density and what each method learnt [dB].
/// @param truth in the cells of the grids, of which there is at least one.
void write_clutter(const std::vector<double>& truth, const std::vector<LearntClutter>& learnt,
                   const std::string& path);

}  // namespace lookout::tools
