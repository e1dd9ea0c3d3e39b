#include "tools/experiments/initiation/zeng_run.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/frames.hpp"
#include "tracking/initiation/methods/vct.hpp"

namespace lookout::tools {
namespace {

double number_or(const Cell& cell, const char* name, double otherwise) {
  return cell.parameters.has(name) ? cell.parameters.number(name) : otherwise;
}

/// Whether [Fan2018] states the method's cells for its own scene, whose plots err by a thirtieth of these.
bool is_of_fan(const std::string& method) {
  return method == "ht" || method == "mht_ti" || method == "iht_ti" || method == "nht_ti";
}

/// Cells and tolerances for [Fan2018]'s methods in the proportion to the errors that its own scene has them:
/// rows and columns of [Zeng2023], tolerances of one of each.
void scale_lines(tracking::InitiatorConfig& config) {
  constexpr double kRow = 750.0;
  config.rho_step = config.rho_tolerance = kRow;
  config.theta_step = config.theta_tolerance = std::numbers::pi / 200.0;
}

}  // namespace

Cell zeng_cell(const ZengRow& row) {
  Cell cell;
  cell.method = row.method;
  cell.parameters = {{"scans", 1.0 * row.scans},
                     {"window_scans", 1.0 * row.window_scans},
                     {"clutter_per_scan", row.clutter},
                     {"detection_probability", row.detection_probability}};
  if (row.min_plots > 0) cell.parameters.set("min_plots", 1.0 * row.min_plots);
  const std::string variant = row.variant;
  if (!variant.empty()) cell.parameters.set("variant", variant);
  return cell;
}

void set_threshold(const std::string& method, double value, tracking::InitiatorConfig& config) {
  if (method == "vct")
    config.max_false_tracks = value;
  else if (method == "modified_logic")
    config.gate_probability = value;
  else if (method == "modified_ht")
    config.max_turn = core::radians(value);
  else if (method == "sequence_ht")
    config.max_tracks = static_cast<int>(value);
  else if (method == "ag_fht" || method == "fpht" || method == "nht_plus" || is_of_fan(method))
    config.peak_threshold = value;
  else
    throw std::invalid_argument("no threshold is known of " + method);
}

tracking::InitiatorConfig zeng_config(const Cell& cell) {
  const Parameters& parameters = cell.parameters;
  tracking::InitiatorConfig config;
  config.min_speed = tracking::kZengSpeeds.min;
  config.max_speed = tracking::kZengSpeeds.max;
  config.acceleration_sigma = 1.0;  // [Zeng2023] section 3.1
  config.window_scans = static_cast<int>(parameters.number("window_scans"));
  if (parameters.has("min_plots")) config.min_plots = static_cast<int>(parameters.number("min_plots"));
  if (parameters.has("variant")) config.variant = parameters.text("variant");
  if (cell.method == "nht_plus" && !config.min_plots) config.min_plots = config.window_scans;
  if (is_of_fan(cell.method)) scale_lines(config);
  // The false tracks that VCT allows itself are those of the run, however many windows it has.
  const int windows = static_cast<int>(parameters.number("scans")) - *config.window_scans + 1;
  if (cell.method == "vct") config.max_false_tracks = tracking::VctParams{}.max_false_tracks / windows;
  if (parameters.has("max_turn_rate_deg"))
    config.max_turn_rate = core::radians(parameters.number("max_turn_rate_deg"));
  if (parameters.has("threshold")) set_threshold(cell.method, parameters.number("threshold"), config);
  return config;
}

ZengSceneParams zeng_params(const Cell& cell) {
  ZengSceneParams params;
  params.num_scans = static_cast<int>(cell.parameters.number("scans"));
  params.clutter_per_scan = cell.parameters.number("clutter_per_scan");
  params.detection_probability = cell.parameters.number("detection_probability");
  params.turn_rate = core::radians(number_or(cell, "turn_rate_deg", 0.0));
  params.acceleration = number_or(cell, "acceleration", 0.0);
  params.told_noise = number_or(cell, "told_noise", 1.0);
  params.clustered = cell.parameters.has("clutter");
  return params;
}

Metrics measure_on_zeng(const Cell& cell, std::uint64_t seed, int run, TrueTrack reading) {
  core::Random random(seed, core::RandomStream::experiment, static_cast<std::uint64_t>(run));
  const ZengSceneParams params = zeng_params(cell);
  const InitiationScene scene = zeng_scene(params, random);
  const auto config = zeng_config(cell);
  const InitiationRun result = params.num_scans > *config.window_scans
                                   ? run_sliding(scene, cell.method, config)
                                   : run_initiator(scene, cell.method, config);
  Metrics metrics = track_metrics(scene, result, *config.window_scans, reading);
  const Metrics lenient = track_metrics(scene, result, *config.window_scans, TrueTrack::lenient);
  metrics["p2_lenient"] = lenient.at("p2");
  if (lenient.count("p3") > 0) metrics["p3_lenient"] = lenient.at("p3");
  return metrics;
}

}  // namespace lookout::tools
