#include <charconv>

#include "core/input_error.hpp"
#include "sonar_sim/sonar_simulator_node.hpp"
#include "tools/cli/live.hpp"
#include "tools/cli/log.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

/// A factor over real time, or nothing for "max".
std::optional<double> parse_speed(const std::string& text) {
  if (text == "max") return std::nullopt;
  double speed = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, speed);
  if (error != std::errc() || stop != end)
    throw core::InputError("--speed: got `" + text + "`, expected a number > 0 or max");
  return speed;
}

/// How long the TRACKS of a scan are waited for. @throws core::InputError where nobody waits.
double answer_wait(const Options& options, const sonar_sim::SimulatorNodeParams& params) {
  const bool waits = !params.speed && params.wait_for_tracks;
  if (options.answer_wait && !waits)
    throw core::InputError("--answer-wait: only --speed max waits for TRACKS, and not into a file://");
  return options.answer_wait.value_or(params.answer_wait);
}

std::string describe(const sonar_sim::SimulatorFigures& figures) {
  std::string line = std::to_string(figures.scans) + " scans sent";
  if (figures.unanswered > 0) line += ", " + std::to_string(figures.unanswered) + " not answered in time";
  if (!figures.complete) line += ", stopped before the end of the scene";
  return line;
}

}  // namespace

int sim_command(const Options& options) {
  if (options.inputs.size() != 1) throw core::InputError("sim: expected one SCENARIO.yaml");
  const sonar_sim::Scene scene = sonar_sim::load_scene(options.inputs[0]);
  const auto limits = loop_limits(options);
  sonar_sim::SimulatorNodeParams params;
  params.channel_prefix = options.channel_prefix;
  params.seed = options.seed;
  params.start_utime = options.start_utime;
  params.speed = parse_speed(options.speed);
  params.wait_for = options.wait_for;
  params.wait_for_tracks = !options.lcm_url.starts_with("file://");
  params.answer_wait = answer_wait(options, params);
  lcmtypes::Bus bus(options.lcm_url);
  sonar_sim::SonarSimulatorNode node(bus, scene, params);
  log_info("sim: seed " + std::to_string(options.seed));
  log_info("sim: " + describe(node.run(limits)));
  if (bus.send_errors() > 0)
    log_warning("sim: " + std::to_string(bus.send_errors()) +
                " messages, of scans, vehicle states and truth, could not be sent: " + bus.send_error());
  return end_of_link(bus);
}

}  // namespace lookout::tools
