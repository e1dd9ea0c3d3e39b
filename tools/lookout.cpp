// The command line: every command and flag of `lookout`, and its exit status.
#include <CLI/CLI.hpp>
#include <iostream>
#include <iterator>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/input_error.hpp"
#include "fusion/fusion_params.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/plugin.hpp"
#include "tools/cli/version.hpp"
#include "tools/commands/commands.hpp"
#include "tools/experiments/experiment_registry.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/track_before_detect/frames/frame_tracker_registry.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

constexpr int kFailure = 1;
constexpr int kBadInput = 2;

/// `WHAT: a b c`, for the help of an option that takes a registry's names.
template <typename Names>
std::string one_of(const std::string& what, const Names& names) {
  std::string text = what + ":";
  for (const auto& name : names) text.append(" ").append(name);
  return text;
}

std::string experiment_choices() {
  std::vector<std::string> names;
  for (const auto& entry : experiment_registry()) names.emplace_back(entry.name);
  return one_of("Which experiment", names);
}

std::string method_choices() {
  return one_of("TRACKER, TRACKER:ESTIMATOR or LABEL=CONFIG.yaml; once for each. Trackers",
                tracking::tracker_names());
}

/// The release, and the commit where it is known.
std::string version_line() {
  const std::string commit = version();
  return "lookout " + release() + (commit == "release " + release() ? "" : " (commit " + commit + ")");
}

// Flags that several commands share, each described once.

void add_seed(CLI::App& app, Options& options) {
  app.add_option("--seed", options.seed, "Seed of every random draw")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
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

/// How many runs, on how many threads, and which part of them.
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

// The flags of each command.

void add_tracking(CLI::App& app, Options& options) {
  app.add_option("--config", options.config, "Configuration YAML");
  app.add_option("--estimator", options.estimator, one_of("Estimator", estimator_choices()));
  app.add_option("--tracker", options.tracker, one_of("Tracker", tracking::tracker_names()));
  add_plugin(app, options);
  app.add_option("--input", options.input,
                 "What is tracked: scan or image (returns are found in SONAR_IMAGE, as `detect` does)")
      ->capture_default_str();
  app.add_option("--lag", options.lag, "Delayed output: tracks as they are known so much later [s]");
  app.add_flag("--explain", options.explain, "One line a track decision on stderr");
}

void declare_run(CLI::App& app, Options& options) {
  app.add_option("SCENARIO", options.inputs, "Scene YAML")->expected(1)->required();
  add_out(app, options);
  add_seed(app, options);
  add_tracking(app, options);
  app.add_flag("--unknown-sensor", options.unknown_sensor,
               "Keep the scene's sensor figures from the tracker: it knows what the configuration says");
  app.add_option("--votes-at", options.votes_at, "Also write csht's vote matrices at this scenario time [s]");
  add_scoring(app, options);
}

void add_live(CLI::App& app, Options& options) {
  app.add_option("--lcm-url", options.lcm_url, "LCM transport (default: LCM_DEFAULT_URL, else LCM's own)");
  app.add_option("--channel-prefix", options.channel_prefix,
                 "Before the vehicle's channel names, e.g. AUV1_");
  app.add_option("--duration", options.duration, "Stop after so long [s of wall time]");
  app.add_option("--idle-exit", options.idle_exit, "Stop after so long without a message [s of wall time]");
}

void declare_sim(CLI::App& app, Options& options) {
  app.add_option("SCENARIO", options.inputs, "Scene YAML")->expected(1)->required();
  app.add_option("--speed", options.speed, "Times real time, or max: as fast as the tracker answers")
      ->capture_default_str();
  app.add_option("--wait-for", options.wait_for, "Trackers to hear on LOOKOUT_STATUS before the first scan")
      ->capture_default_str();
  app.add_option("--start-utime", options.start_utime, "Scenario time of the first scan [us]")
      ->capture_default_str();
  add_seed(app, options);
  add_live(app, options);
}

void declare_track(CLI::App& app, Options& options) {
  add_tracking(app, options);
  add_seed(app, options);
  app.add_flag("--publish-estimates", options.publish_estimates, "Also publish LOCAL_ESTIMATE, for fusion");
  app.add_option("--node-id", options.node_id, "Of this vehicle, 1 or more")->capture_default_str();
  app.add_option("--state", options.state,
                 "File that keeps what is known, every two seconds: a restart goes on by it; scans alone");
  add_live(app, options);
}

void declare_fuse(CLI::App& app, Options& options) {
  app.add_option(
      "--method", options.method,
      one_of("Method (default: the configuration's, else learned)", fusion::fusion_method_names()));
  app.add_option("--config", options.config, "Configuration YAML");
  app.add_option("--seed", options.seed, "Of random draws; no method of today draws")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  add_live(app, options);
}

void declare_score(CLI::App& app, Options& options) {
  app.add_option("--tracks", options.tracks_channel, "Channel to score (default: TRACKS with the prefix)");
  add_scoring(app, options);
  add_live(app, options);
}

void declare_replay(CLI::App& app, Options& options) {
  app.add_option("INPUT", options.inputs, "Recording directory, or LCM logs in order")
      ->expected(1, -1)
      ->required();
  add_out(app, options);
  add_seed(app, options);
  add_tracking(app, options);
  app.add_option("--channel-prefix", options.channel_prefix,
                 "Of the vehicle whose channels to take from a log");
  app.add_option("--votes-at", options.votes_at, "Also write csht's vote matrices at this scenario time [s]");
  add_scoring(app, options);
}

void declare_ospa(CLI::App& app, Options& options) {
  app.add_option(
         "FILES", options.inputs,
         "TRUTH.csv and ESTIMATE.csv, or two directories whose files of one name are pairs. Columns: time_s, "
         "north_m, east_m; and where present id (ospa2 and tgospa need it), north_velocity_mps, "
         "east_velocity_mps; of the truth visible (0 or 1); of the estimate status (tentative confirmed "
         "coasting), existence")
      ->expected(2)
      ->required();
  add_scoring(app, options);
  app.add_option("--metric", options.metric,
                 "ospa, gospa, ospa2 (tracks over a window) or tgospa (tracks over the run)")
      ->capture_default_str();
  app.add_option(
      "--times", options.times,
      "CSV whose time_s column names the times to average over (default: the scans.csv beside TRUTH.csv, "
      "else all times of either file)");
  app.add_option("--time-tolerance", options.time_tolerance,
                 "Times that differ by no more are one [s] (default: 1e-6)");
  app.add_flag("--interpolate", options.interpolate, "Take the truth between its times on straight lines");
  app.add_option(
      "--over-time", options.over_time,
      "Also write the metric over time to this CSV; of directories, one a pair into this directory");
  app.add_option("--window", options.window,
                 "ospa2: how far each value looks back [s] (default: to the first time)");
  app.add_option("--switch-penalty", options.switch_penalty,
                 "tgospa: price of a target's change of track [m] (default: a tenth of the cut-off)");
  app.add_flag("--json", options.json, "Print one line of JSON");
}

void declare_tbd(CLI::App& app, Options& options) {
  app.add_option("METHOD", options.method, one_of("Method", tracking::frame_tracker_names()))->required();
  app.add_option("FRAMES_DIR", options.inputs,
                 "Directory of PGM or PPM frames, taken in order of name, or a recording with images.csv")
      ->expected(1)
      ->required();
  app.add_option("--out", options.out, "CSV file to write");
  app.add_option("--config", options.config, "Configuration YAML; its part tbd");
  add_seed(app, options);
}

void declare_detect(CLI::App& app, Options& options) {
  app.add_option("INPUT", options.inputs,
                 "Recording of images, or LCM logs in order; without one, live: SONAR_IMAGE -> SONAR_SCAN");
  app.add_option("--out", options.out, "Recording directory to write");
  app.add_option("--config", options.config, "Configuration YAML; its parts detect and sensor");
  add_live(app, options);
}

void declare_initiate(CLI::App& app, Options& options) {
  app.add_option("METHOD", options.method, one_of("Initiator", tracking::initiator_names()))->required();
  app.add_option("POINTS", options.inputs, "CSV of scan,time_s,x_m,y_m")->expected(1)->required();
  app.add_option("--out", options.out, "TRACKS.csv to write");
  app.add_option("--config", options.config, "Configuration YAML; its `initiator:` part is used");
  add_plugin(app, options);
}

void declare_import(CLI::App& app, Options& options) {
  app.add_option("FORMAT", options.method, one_of("Format", import_formats()))->required();
  app.add_option("FILE", options.inputs,
                 "oculus: packet streams in order; pgm: FOLDER [GEOMETRY.yaml]; autoferry: DETECTIONS.json "
                 "GROUND_TRUTH.json")
      ->expected(1, -1)
      ->required();
  add_out(app, options);
}

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

/// What `compare` and `tune` are measured with.
void add_comparing(CLI::App& app, Options& options) {
  app.add_flag("--unknown-sensor", options.unknown_sensor,
               "Keep the scenes' sensor figures from the trackers: they know what the configuration says");
  add_scoring(app, options);
  app.add_option("--window", options.window, "How far OSPA(2) looks back [s] (default: 10)");
  app.add_option(
      "--switch-penalty", options.switch_penalty,
      "Of trajectory GOSPA: price of a target's change of track [m] (default: a tenth of the cut-off)");
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

void declare_watch(CLI::App& app, Options& options) {
  app.add_option("LOG", options.inputs, "LCM log to look through; without one, live")->expected(0, 1);
  app.add_option("--http", options.http, "PORT or ADDRESS:PORT to serve at")->capture_default_str();
  app.add_option("--decisions", options.decisions,
                 "File that a tracker's --explain lines go to: shown with their track");
  add_live(app, options);
}

void declare_status(CLI::App& app, Options& options) {
  app.add_flag("--once", options.once, "Listen some seconds, print, exit with 0 (healthy) or 1");
  add_live(app, options);
}

void declare_plot(CLI::App& app, Options& options) {
  app.add_option("INPUT", options.inputs, "Directory of run, replay or anyone's recording, or an LCM log")
      ->expected(1)
      ->required();
  app.add_option("--out", options.out,
                 "FILE.png, .pdf or .gif (default: lookout.png and .pdf in the directory)");
  app.add_flag("--animate", options.animate, "Also draw an animation, a GIF");
  app.add_option("--channel-prefix", options.channel_prefix,
                 "Of the vehicle whose channels to take from a log");
  add_scoring(app, options);
}

void declare_fault(CLI::App& app, Options& options) {
  app.add_option("PLAN", options.inputs, "Fault plan YAML (docs/faults.md)")->expected(1)->required();
  app.add_option("--to-prefix", options.to_prefix,
                 "Before the channel names to speak on, e.g. FAULTY_ (default: none)");
  app.add_option("--to-url", options.to_url, "LCM transport to speak on (default: that of --lcm-url)");
  add_seed(app, options);
  add_live(app, options);
}

void declare_doctor(CLI::App& app, Options& options) {
  app.add_option("--lcm-url", options.lcm_url, "LCM transport (default: LCM_DEFAULT_URL, else LCM's own)");
  app.add_option("--channel-prefix", options.channel_prefix,
                 "Before the vehicle's channel names, e.g. AUV1_");
  app.add_option("--out", options.out, "Directory that is to be written to (default: this one)");
  app.add_option("--state", options.state, "File that `track --state` is to keep");
}

struct Command {
  const char* name;
  const char* summary;
  const char* example;
  void (*declare)(CLI::App& app, Options& options);
  int (*run)(const Options& options);
};

constexpr Command kCommands[] = {
    {"run", "Runs a scene through the whole chain in one process, as fast as it computes.",
     "lookout run tools/scenarios/tracking_table7.yaml --out out/run", declare_run, run_command},
    {"sim", "Publishes a scene's vehicle states, scans and truth over LCM.",
     "lookout sim tools/scenarios/tracking_table7.yaml --wait-for 1", declare_sim, sim_command},
    {"track", "The on-vehicle process: scans in, tracks out, over LCM.", "lookout track --node-id 1",
     declare_track, track_command},
    {"fuse", "Joins the estimates of several vehicles: LOCAL_ESTIMATE in, GLOBAL_TRACKS out, over LCM.",
     "lookout fuse --method learned", declare_fuse, fuse_command},
    {"score", "Scores TRACKS against GROUND_TRUTH live over LCM; prints the mean at its end.",
     "lookout score --truth visible", declare_score, score_command},
    {"replay", "Tracks a recording or an LCM log again, the same tracks every time.",
     "lookout replay out/demo/demo.lcmlog --out out/replay", declare_replay, replay_command},
    {"ospa", "Scores estimated positions against the truth, offline.",
     "lookout ospa out/run/truth.csv out/run/tracks.csv --cutoff 20", declare_ospa, ospa_command},
    {"tbd", "Tracks targets in the raw intensities of an image sequence.",
     "lookout tbd i_h_pmht_4 tools/data/tbd_example --config tools/data/tbd_example/config.yaml --out "
     "tracks.csv",
     declare_tbd, tbd_command},
    {"detect", "Finds returns in sonar images, one an echo, at a stated false-alarm rate: live or recorded.",
     "lookout detect out/images --out out/returns", declare_detect, detect_command},
    {"initiate", "Starts tracks on recorded points with one initiator.",
     "lookout initiate vct points.csv --out tracks.csv --config radar.yaml", declare_initiate,
     initiate_command},
    {"import", "Makes a recording of a vendor's files.", "lookout import oculus dive.raw --out out/dive",
     declare_import, import_command},
    {"experiment", "Runs a paper's experiment, Monte Carlo, and sets our figures beside the paper's.",
     "lookout experiment csht-window --runs 20 --only p_miss=0.1 --out out/window", declare_experiment,
     experiment_command},
    {"compare", "Runs trackers on scenes of your own with common seeds: curves, tests, tables, a report.",
     "lookout compare tools/scenarios/crossing.yaml --method joint --method gnn --runs 50 --out out/compare",
     declare_compare, compare_command},
    {"tune", "Sweeps one parameter of a tracker over a scene with common seeds, and plots what it does.",
     "lookout tune tools/scenarios/crossing.yaml --parameter joint.birth.begin_nats=8:14 --runs 20 --out "
     "out/tune",
     declare_tune, tune_command},
    {"merge",
     "Joins the shards of an experiment or a comparison into one result, as if one machine had done all.",
     "lookout merge shards/* --out out/window", declare_merge, merge_command},
    {"watch", "Shows what the sonar hears and the tracker believes, live or out of a log, in a browser.",
     "lookout watch --http 8080", declare_watch, watch_command},
    {"status", "Shows in a terminal whether the chain is healthy, and why not.", "lookout status --once",
     declare_status, status_command},
    {"plot", "Draws a run, a replay, a log or anyone's recording.", "lookout plot out/run", declare_plot,
     plot_command},
    {"fault", "Relays traffic from one channel prefix to another and spoils it by plan and seed.",
     "lookout fault tools/scenarios/faults/scan_lost.yaml --to-prefix FAULTY_", declare_fault, fault_command},
    {"doctor", "Checks this computer and its link, and says what to type; exit 1 where something would fail.",
     "lookout doctor --channel-prefix AUV1_", declare_doctor, doctor_command},
};

/// One line for a person; the status for a script.
int report(const std::string& message, int status) {
  std::cerr << "lookout: " << message << "\n";
  return status;
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Lookout: what moves around an underwater vehicle, from the returns of its sonar.", "lookout");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_line);
  const Command* chosen = nullptr;
  for (const auto& command : kCommands) {
    auto* sub = app.add_subcommand(command.name, command.summary);
    sub->description(std::string("Example:\n  ") + command.example + "\n\n" + command.summary);
    command.declare(*sub, options);
    sub->callback([&chosen, &command] { chosen = &command; });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForAllHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForVersion& version) {
    return app.exit(version);
  } catch (const CLI::ParseError& error) {
    return report(error.what(), kBadInput);
  }
  const int status = chosen->run(options);
  std::cout.flush();
  return std::cout ? status : report("standard output: could not be written", kFailure);
}

}  // namespace
}  // namespace lookout::tools

int main(int argc, char** argv) {
  using namespace lookout::tools;
  try {
    return run(argc, argv);
  } catch (const lookout::core::InputError& error) {
    return report(error.what(), kBadInput);
  } catch (const std::invalid_argument& error) {  // A parameter that the library refuses, by name and value.
    return report(error.what(), kBadInput);
  } catch (const std::bad_alloc&) {
    return report("out of memory", kFailure);
  } catch (const std::exception& error) {
    return report(error.what(), kFailure);
  }
}
