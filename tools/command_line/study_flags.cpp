// Flags of the commands that run trackers many times.
#include <CLI/CLI.hpp>

#include "tools/cli/configuration.hpp"
#include "tools/command_line/command_flags.hpp"
#include "tools/command_line/shared_flags.hpp"
#include "tools/experiments/experiment_registry.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

std::string experiment_choices() {
  std::vector<std::string> names;
  for (const auto& entry : experiment_registry()) names.emplace_back(entry.name);
  return one_of("Which experiment", names);
}

}  // namespace

void declare_experiment(CLI::App& app, Options& options) {
  app.add_option("NAME", options.method, experiment_choices());
  add_out(app, options);
  add_seed(app, options);
  app.add_flag("--list", options.list, "Name the experiments and stop");
  add_monte_carlo(app, options);
  app.add_option("--only", options.only, "KEY=VALUE: only the cells with it; may be repeated")
      ->allow_extra_args(false);
  add_plugin(app, options);
}

void declare_tune(CLI::App& app, Options& options) {
  app.add_option("SCENE", options.inputs, "Scene YAML")->expected(1)->required();
  app.add_option(
         "--parameter", options.parameters,
         "KEY=FROM:TO or KEY=FROM:TO:COUNT (7): a parameter of the tracker, as docs/parameters.md names it")
      ->allow_extra_args(false);
  add_out(app, options);
  add_seed(app, options);
  add_monte_carlo(app, options);
  app.add_option("--config", options.config, "Configuration YAML");
  app.add_option("--estimator", options.estimator, one_of("Estimator", estimator_choices()));
  app.add_option("--tracker", options.tracker, one_of("Tracker", tracking::tracker_names()));
  add_plugin(app, options);
  add_comparing(app, options);
}

void declare_compare(CLI::App& app, Options& options) {
  app.add_option("SCENE", options.inputs, "Scene YAMLs")->expected(1, -1)->required();
  app.add_option("--method", options.methods, method_choices())->allow_extra_args(false);
  add_out(app, options);
  add_seed(app, options);
  add_monte_carlo(app, options);
  app.add_option("--config", options.config, "Configuration YAML of the methods that have none of their own");
  add_plugin(app, options);
  add_comparing(app, options);
}

void declare_merge(CLI::App& app, Options& options) {
  app.add_option("DIR", options.inputs, "Directories that --shard K/N wrote, in any order")
      ->expected(1, -1)
      ->required();
  add_out(app, options);
}

}  // namespace lookout::tools
