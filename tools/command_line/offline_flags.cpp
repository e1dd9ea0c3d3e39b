// Flags of the commands from files to files.
#include <CLI/CLI.hpp>

#include "tools/command_line/command_flags.hpp"
#include "tools/command_line/shared_flags.hpp"
#include "tools/commands/commands.hpp"
#include "tracking/initiation/initiator_registry.hpp"
#include "tracking/track_before_detect/frames/frame_tracker_registry.hpp"

namespace lookout::tools {

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

}  // namespace lookout::tools
