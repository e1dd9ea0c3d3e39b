#include "tools/command_line/shared_flags.hpp"

#include <charconv>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "tools/cli/configuration.hpp"
#include "tools/cli/plugin.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {

std::string method_choices() {
  return one_of("TRACKER, TRACKER:ESTIMATOR or LABEL=CONFIG.yaml; once for each. Trackers",
                tracking::tracker_names());
}

std::string seed_defect(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error == std::errc() && end == text.data() + text.size()) return {};
  return "got `" + text + "`, expected a whole number from 0 to 18446744073709551615";
}

void add_seed(CLI::App& app, Options& options) {
  app.add_option("--seed", options.seed, "Seed of every random draw")
      ->capture_default_str()
      ->check(&seed_defect);
}

void add_out(CLI::App& app, Options& options) {
  app.add_option("--out", options.out, "Directory to write");
}

void add_scoring(CLI::App& app, Options& options) {
  app.add_option("--cutoff", options.cutoff, "OSPA cut-off [m]")->capture_default_str();
  app.add_option("--order", options.order, "OSPA order, 1 or more, or inf")->capture_default_str();
  app.add_option("--truth", options.truth,
                 "visible: targets in the field of view, coasting tracks left out; schedule: all")
      ->capture_default_str();
}

namespace {

/// The names in the help text of a command, plug-ins' included.
void describe_names(CLI::App& app) {
  const auto describe = [&app](const char* option, const std::string& text) {
    if (auto* found = app.get_option_no_throw(option)) found->description(text);
  };
  describe("--estimator", one_of("Estimator", estimator_choices()));
  describe("--tracker", one_of("Tracker", tracking::tracker_names()));
  describe("--method", method_choices());
  describe("METHOD", one_of("Initiator", tracking::initiator_names()));
}

}  // namespace

/// Plug-ins are loaded while the flags are read, so that help and errors know their names.
void add_plugin(CLI::App& app, Options& options) {
  const auto load = [&app, &options](const std::vector<std::string>& files) {
    for (const auto& file : files) load_plugin(file);
    options.plugins.insert(options.plugins.end(), files.begin(), files.end());
    describe_names(app);
  };
  app.add_option_function<std::vector<std::string>>(
         "--plugin", load,
         "Shared library with estimators, trackers and initiators of your own; may be repeated")
      ->type_name("FILE.so")
      ->allow_extra_args(false);
}

void add_monte_carlo(CLI::App& app, Options& options) {
  app.add_option("--runs", options.runs, "Monte Carlo runs a cell")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  app.add_option("--jobs", options.jobs, "Threads; 0 takes all cores")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  app.add_flag("--resume", options.resume, "Go on where an interrupted one stopped");
  app.add_option("--shard", options.shard,
                 "K/N: do this part of the runs alone; `lookout merge` joins the parts");
}

void add_tracking(CLI::App& app, Options& options) {
  app.add_option("--config", options.config, "Configuration YAML");
  app.add_option("--estimator", options.estimator, one_of("Estimator", estimator_choices()));
  app.add_option("--tracker", options.tracker, one_of("Tracker", tracking::tracker_names()));
  add_plugin(app, options);
  app.add_option("--input", options.input,
                 "What is tracked: scan or image (returns are found in SONAR_IMAGE, as `detect` does)")
      ->capture_default_str();
  app.add_option("--lag", options.lag, "Delayed output: tracks as they are known so much later [s]");
  app.add_flag("--explain", options.explain,
               "One line a track decision on stderr; `track` also sends them as DECISIONS");
}

void add_live(CLI::App& app, Options& options) {
  app.add_option("--lcm-url", options.lcm_url, "LCM transport (default: LCM_DEFAULT_URL, else LCM's own)");
  app.add_option("--channel-prefix", options.channel_prefix,
                 "Before the vehicle's channel names, e.g. AUV1_");
  app.add_option("--duration", options.duration, "Stop after so long [s of wall time]");
  app.add_option("--idle-exit", options.idle_exit, "Stop after so long without a message [s of wall time]");
}

void add_comparing(CLI::App& app, Options& options) {
  app.add_flag("--unknown-sensor", options.unknown_sensor,
               "Keep the scenes' sensor figures from the trackers: they know what the configuration says");
  add_scoring(app, options);
  app.add_option("--window", options.window, "How far OSPA(2) looks back [s] (default: 10)");
  app.add_option(
      "--switch-penalty", options.switch_penalty,
      "Of trajectory GOSPA: price of a target's change of track [m] (default: a tenth of the cut-off)");
}

}  // namespace lookout::tools
