#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/experiments/harness/experiment.hpp"
#include "tools/experiments/harness/study.hpp"

namespace lookout::tools {

/// `--only KEY=VALUE`: keys are parameter names or `method`.
struct Filter {
  std::string key;
  std::string value;
};

/// @throws core::InputError on a word without `=`.
std::vector<Filter> parse_filters(const std::vector<std::string>& words);

/// Same key: or. Different keys: and. Numbers are compared as numbers.
bool passes(const Cell& cell, const std::vector<Filter>& filters);

struct MonteCarloOptions {
  std::uint64_t seed = 1;
  int runs = 100;
  int jobs = 0;  ///< Threads; 0: all cores.
  std::vector<Filter> only;
  std::string progress_file;         ///< One JSON line a finished run; empty: none.
  bool resume = false;               ///< Take the runs that the progress file already holds.
  Shard shard;                       ///< Do this part of the (cell, run) tasks alone.
  std::vector<std::string> plugins;  ///< Files of plug-ins that are loaded; they are part of the study.
};

struct CellResult {
  Cell cell;
  Estimates metrics;
};

struct ExperimentResults {
  std::string name;
  std::uint64_t seed = 1;
  int runs = 0;
  std::vector<CellResult> cells;
};

/// Pools the runs of one metric; runs without a value are left out.
Estimate pool(const std::vector<Metric>& runs, Pooling pooling);

/// What `lookout experiment NAME` with these options is a part of. @throws core::InputError where a plug-in
/// cannot be read.
Study study_of(const std::string& name, const MonteCarloOptions& options);

/// Runs every cell that passes the filters. The work is a list of independent (cell, run) tasks; results
/// depend on the seed alone, neither on the number of threads nor on their order. A shard's results hold
/// its own runs alone: `merge_logs` joins the progress files of all.
/// @throws core::InputError where nothing passes the filters, and what a run throws.
ExperimentResults run_monte_carlo(const Experiment& experiment, const std::string& name,
                                  const MonteCarloOptions& options);

}  // namespace lookout::tools
