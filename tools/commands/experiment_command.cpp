#include <iostream>
#include <sstream>

#include "core/input_error.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/paths.hpp"
#include "tools/commands/commands.hpp"
#include "tools/experiments/experiment_registry.hpp"
#include "tools/experiments/harness/monte_carlo.hpp"
#include "tools/experiments/harness/report.hpp"

namespace lookout::tools {
namespace {

int list_experiments() {
  for (const auto& entry : experiment_registry())
    std::cout << entry.name << "\t" << entry.make()->summary() << "\n";
  return 0;
}

MonteCarloOptions monte_carlo_options(const Options& options) {
  MonteCarloOptions result;
  result.seed = options.seed;
  result.runs = options.runs;
  result.jobs = options.jobs;
  result.only = parse_filters(options.only);
  result.progress_file = options.out + "/runs.jsonl";
  result.resume = options.resume;
  return result;
}

/// The line that makes these results again, whatever the defaults are then.
std::string command_line(const Options& options) {
  std::ostringstream line;
  line << "lookout experiment " << options.method << " --runs " << options.runs << " --seed " << options.seed;
  for (const auto& file : options.plugins) line << " --plugin " << file;
  for (const auto& filter : options.only) line << " --only " << filter;
  line << " --out " << options.out;
  return line.str();
}

}  // namespace

int experiment_command(const Options& options) {
  if (options.list) return list_experiments();
  if (options.method.empty()) throw core::InputError("experiment: NAME is missing; `--list` shows the names");
  if (options.out.empty()) throw core::InputError("experiment: --out DIR is missing");
  const auto experiment = make_experiment(options.method);
  if (const std::string missing = experiment->missing_input(); !missing.empty()) {
    log_warning(options.method + " skipped: " + missing);
    return 0;
  }
  make_directory(options.out);
  const MonteCarloOptions how = monte_carlo_options(options);
  ExperimentResults results = run_monte_carlo(*experiment, options.method, how);
  results.command = command_line(options);
  write_results(*experiment, results, options.out);
  log_info("wrote " + options.out + "/results.json, results.csv and report.md");
  experiment->write_extras({options.seed, options.runs, options.jobs,
                            chosen_cells(*experiment, options.method, how.only), options.out});
  if (!experiment->plot_script().empty()) run_plot_script(experiment->plot_script(), {options.out});
  return 0;
}

}  // namespace lookout::tools
