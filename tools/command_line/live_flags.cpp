// Flags of the commands that speak on a link.
#include <CLI/CLI.hpp>

#include "fusion/fusion_params.hpp"
#include "tools/command_line/command_flags.hpp"
#include "tools/command_line/shared_flags.hpp"

namespace lookout::tools {

void declare_sim(CLI::App& app, Options& options) {
  app.add_option("SCENARIO", options.inputs, "Scene YAML")->expected(1)->required();
  app.add_option("--speed", options.speed, "Times real time, or max: as fast as the tracker answers")
      ->capture_default_str();
  app.add_option("--answer-wait", options.answer_wait,
                 "At --speed max, the longest wait for the TRACKS of a scan [s], above 0 (default: 1)");
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
  app.add_option(
      "--publish-clutter", options.clutter_every,
      "Also publish CLUTTER_MAP, what is learnt of the clutter, every so many seconds of data; joint, "
      "csht, kalman and gnn (default: never)");
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
      ->check(&seed_defect);
  add_live(app, options);
}

void declare_score(CLI::App& app, Options& options) {
  app.add_option("--tracks", options.tracks_channel, "Channel to score (default: TRACKS with the prefix)");
  add_scoring(app, options);
  add_live(app, options);
}

void declare_detect(CLI::App& app, Options& options) {
  app.add_option("INPUT", options.inputs,
                 "Recording of images, or LCM logs in order; without one, live: SONAR_IMAGE -> SONAR_SCAN");
  app.add_option("--out", options.out, "Recording directory to write");
  app.add_option("--config", options.config, "Configuration YAML; its parts detect and sensor");
  add_live(app, options);
}

void declare_fault(CLI::App& app, Options& options) {
  app.add_option("PLAN", options.inputs, "Fault plan YAML (docs/faults.md)")->expected(1)->required();
  app.add_option("--to-prefix", options.to_prefix,
                 "Before the channel names to speak on, e.g. FAULTY_ (default: none)");
  app.add_option("--to-url", options.to_url, "LCM transport to speak on (default: that of --lcm-url)");
  add_seed(app, options);
  add_live(app, options);
}

}  // namespace lookout::tools
