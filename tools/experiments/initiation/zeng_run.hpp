#pragma once

#include "tools/experiments/initiation/initiation_run.hpp"

/// One cell of the experiments on the scene of [Zeng2023].
namespace lookout::tools {

/// One row: a method, its reading, how many of how many scans, the clutter and the detection probability.
struct ZengRow {
  const char* method;
  const char* variant;
  int scans;
  int window_scans;
  int min_plots;  ///< 0: the method's own.
  double clutter;
  double detection_probability;
};

/// The cell of a row.
Cell zeng_cell(const ZengRow& row);

/// What a cell says of its method: the paper's limits of speed and acceleration, its window, K, variant and
/// threshold (`threshold`, of the key that tunes the method) where it has them.
tracking::InitiatorConfig zeng_config(const Cell& cell);

/// What a cell says of its scene: scans, clutter, detection probability, and what goes beyond the paper.
ZengSceneParams zeng_params(const Cell& cell);

/// The metrics of one run: one window, or every window in turn where the scene is longer.
/// @param reading of a true track; the lenient one's p2 and p3 stand beside it.
Metrics measure_on_zeng(const Cell& cell, std::uint64_t seed, int run, TrueTrack reading);

/// Sets the threshold that trades true tracks for false ones: the key of the configuration that each method
/// has for it. @throws std::invalid_argument of a method that has none.
void set_threshold(const std::string& method, double value, tracking::InitiatorConfig& config);

}  // namespace lookout::tools
