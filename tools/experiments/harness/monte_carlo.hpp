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
  std::string command;  ///< What was typed; empty where a program of one's own called.
};

/// The cells of an experiment that pass the filters, in its order.
/// @throws core::InputError where none does.
std::vector<Cell> chosen_cells(const Experiment& experiment, const std::string& name,
                               const std::vector<Filter>& only);

/// Half width of the two-sided 95 % interval of a mean over `runs` independent runs, by Student's t with
/// runs - 1 degrees of freedom; NaN from fewer than two.
/// @param standard_error of the mean.
double half_width_95(double standard_error, int runs);

/// Pools the runs of one metric; runs without a value are left out.
Estimate pool(const std::vector<Metric>& runs, Pooling pooling);

/// sqrt(A^2 + B^2) of the means A, B of two parts that the same runs report, as [Yan2018] Tables 10 and 13
/// make a total of the parts in Tables 8, 9, 11 and 12: never above the mean of the runs' own totals. The
/// interval is linearised over the runs, correlation of the parts included.
/// @param first, second of the same runs in one order, with weights of one.
Estimate norm_of_means(const std::vector<Metric>& first, const std::vector<Metric>& second);

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
