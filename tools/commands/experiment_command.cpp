#include <iostream>

#include "core/input_error.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/plugin.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/finish.hpp"
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
  result.shard = parse_shard(options.shard);
  result.plugins = options.plugins;
  return result;
}

/// Results, report, extras and plots of all runs.
void report(const Experiment& experiment, const Options& options, const MonteCarloOptions& how) {
  ExperimentResults results = run_monte_carlo(experiment, options.method, how);
  results.command = study_of(options.method, how).command;
  write_results(experiment, results, options.out);
  log_info("wrote " + options.out + "/results.json, results.csv and report.md");
  experiment.write_extras({options.seed, options.runs, options.jobs,
                           chosen_cells(experiment, options.method, how.only), options.out});
  if (!experiment.plot_script().empty()) run_plot_script(experiment.plot_script(), {options.out});
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
  const MonteCarloOptions monte_carlo = monte_carlo_options(options);
  make_directory(options.out);
  if (monte_carlo.shard.is_whole()) {
    report(*experiment, options, monte_carlo);
    return 0;
  }
  run_monte_carlo(*experiment, options.method, monte_carlo);
  log_info("shard " + monte_carlo.shard.text() + " is in " + options.out + ": `lookout merge` joins all");
  return 0;
}

void finish_experiment(const Study& study, const std::string& out) {
  Options options;
  options.method = study.name;
  options.seed = study.seed;
  options.runs = study.runs;
  options.out = out;
  options.resume = true;
  if (const auto only = study.words.find("only"); only != study.words.end()) options.only = only->second;
  for (const auto& [file, digest] : study.inputs) {
    load_plugin(file);
    options.plugins.push_back(file);
  }
  const auto experiment = make_experiment(study.name);
  report(*experiment, options, monte_carlo_options(options));
}

}  // namespace lookout::tools
