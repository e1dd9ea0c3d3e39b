// Source: modified logic-based initiation of Su and Wang, as compared against by [Zeng2023] section 3.2.
#include "tracking/initiation/methods/modified_logic.hpp"

#include <string>

#include "core/parameter_check.hpp"
#include "tracking/association/gating.hpp"

namespace lookout::tracking {
namespace {

constexpr double kIsotropicVariance = 25000.0;  // [m^2], of the authors' program; docs/initiators.md.
constexpr double kGate = 25.0;                  // Likewise.

}  // namespace

ModifiedLogicInitiator::ModifiedLogicInitiator(const ModifiedLogicParams& params)
    : params_(params), gates_(params.gates) {
  core::require(params.min_plots >= 2, "min_plots must be >= 2", params.min_plots);
  core::require(params.window_scans >= 2, "window_scans must be >= 2", params.window_scans);
}

const StartedTracks& ModifiedLogicInitiator::start(const PlotWindow& window) {
  started_.clear();
  for (const GateTrack& track : gates_.run(window)) {
    if (track.num_plots < params_.min_plots) continue;
    add_track(window, gates_.plots_of(track), params_.gates.motion, track.num_plots, started_);
  }
  gates_.append_survivors(started_.survivors);
  return started_;
}

std::unique_ptr<Initiator> make_modified_logic(const InitiatorConfig& config) {
  config.validate();
  const std::string variant = chosen_variant(
      config, "modified_logic", {"polar", "polar_outside_gates", "polar_all_plots", "isotropic"});
  ModifiedLogicParams params;
  params.gates.speeds = speed_limits(config, kZengSpeeds);
  params.gates.margin = config.gate_margin.value_or(0.0);
  params.gates.limit_turns(config.max_turn);
  params.gates.fan_gate = false;
  params.gates.filtered = false;
  params.gates.new_roots = new_roots_of(variant);
  params.gates.gate = config.gate_probability ? chi_square_gate(*config.gate_probability, 2) : kGate;
  params.gates.motion.acceleration_sigma = config.acceleration_sigma.value_or(1.0);
  if (variant == "isotropic") params.gates.noise = kIsotropicVariance * Eigen::Matrix2d::Identity();
  params.min_plots = config.min_plots.value_or(params.min_plots);
  params.window_scans = config.window_scans.value_or(params.window_scans);
  return std::make_unique<ModifiedLogicInitiator>(params);
}

}  // namespace lookout::tracking
