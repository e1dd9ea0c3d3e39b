#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "sonar_sim/scene.hpp"

namespace lookout::tools {

/// The conditions of a real sea; each is the file tools/scenarios/sea_CONDITION.yaml. docs/sea.md
std::span<const char* const> sea_conditions();

/// The scene of a condition with the given probabilities and four targets drawn for the run: 0.8 to 1.3 m/s,
/// inside the sector at 40 to 150 m when they come (two at the start, one at 10 s, one at 20 s) and half way
/// to the end. All conditions of a run have the same targets.
sonar_sim::Scene sea_scene(const std::string& condition, double p_false_alarm, double p_miss,
                           std::uint64_t seed, int run);

}  // namespace lookout::tools
