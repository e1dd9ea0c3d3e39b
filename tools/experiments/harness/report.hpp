#pragma once

#include <string>

#include "tools/experiments/harness/monte_carlo.hpp"

namespace lookout::tools {

/// Writes results.json, results.csv and report.md into `directory`.
void write_results(const Experiment& experiment, const ExperimentResults& results,
                   const std::string& directory);

}  // namespace lookout::tools
