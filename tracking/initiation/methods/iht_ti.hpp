// Source: Liu, Liu, Xiong, improved Hough transform with a motion prior, 2016, as described by [Fan2018]
// section V.
#pragma once

#include <memory>

#include "tracking/initiation/initiator.hpp"
#include "tracking/initiation/initiator_config.hpp"

namespace lookout::tracking {

/// What it uses of the `initiator:` part of a configuration.
inline constexpr std::initializer_list<const char*> kIhtTiKeys{
    "min_speed",      "max_speed",     "gate_margin",         "rho_step",
    "theta_step_deg", "rho_tolerance", "theta_tolerance_deg", "peak_threshold",
    "min_plots",      "max_tracks",    "window_scans",        "acceleration_sigma"};

/// MHT-TI whose pairs must respect the speed limits, 100 to 400 m/s by default [Fan2018] section V. The
/// original is not accessible; [Fan2018] describes it only by this. Keys: `min_speed`, `max_speed`,
/// `gate_margin` and those of LineVotingParams. No variants.
std::unique_ptr<Initiator> make_iht_ti(const InitiatorConfig& config);

}  // namespace lookout::tracking
