// Flags of the commands that look at a chain, a log or this computer.
#include <CLI/CLI.hpp>

#include "tools/command_line/command_flags.hpp"
#include "tools/command_line/shared_flags.hpp"

namespace lookout::tools {

void declare_watch(CLI::App& app, Options& options) {
  app.add_option("LOG", options.inputs, "LCM log to look through; without one, live")->expected(0, 1);
  app.add_option("--http", options.http, "PORT or ADDRESS:PORT to serve at")->capture_default_str();
  app.add_option("--decisions", options.decisions,
                 "File of a tracker's --explain lines, shown with their track in place of DECISIONS");
  add_live(app, options);
}

void declare_status(CLI::App& app, Options& options) {
  app.add_flag("--once", options.once, "Listen some seconds, print, exit with 0 (healthy) or 1");
  add_live(app, options);
}

void declare_plot(CLI::App& app, Options& options) {
  app.add_option("INPUT", options.inputs,
                 "Directory of run, replay or anyone's recording, a CSV file, or an LCM log")
      ->expected(1)
      ->required();
  app.add_option("--out", options.out,
                 "FILE.png, .pdf or .gif (default: lookout.png and .pdf in the directory)");
  app.add_flag("--animate", options.animate, "Also draw an animation, a GIF");
  app.add_option("--channel-prefix", options.channel_prefix,
                 "Of the vehicle whose channels to take from a log");
  add_scoring(app, options);
}

void declare_doctor(CLI::App& app, Options& options) {
  app.add_option("--lcm-url", options.lcm_url, "LCM transport (default: LCM_DEFAULT_URL, else LCM's own)");
  app.add_option("--channel-prefix", options.channel_prefix,
                 "Before the vehicle's channel names, e.g. AUV1_");
  app.add_option("--out", options.out, "Directory that is to be written to (default: this one)");
  app.add_option("--state", options.state, "File that `track --state` is to keep");
}

}  // namespace lookout::tools
