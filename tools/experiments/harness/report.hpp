#pragma once

#include <string>

#include "tools/experiments/harness/monte_carlo.hpp"

namespace lookout::tools {

/// Writes results.json, results.csv and report.md into `directory`.
void write_results(const Experiment& experiment, const ExperimentResults& results,
                   const std::string& directory);

/// Writes DIRECTORY/pictured_NAME.json: the parameters of the cell that pictures show, the seed, and how many
/// runs a curve is the mean of. Captions are made of it.
void write_pictured(const Cell& cell, const Drawn& drawn, int runs, const std::string& name);

}  // namespace lookout::tools
