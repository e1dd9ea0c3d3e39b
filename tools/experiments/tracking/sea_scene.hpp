#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "sonar_sim/scene.hpp"

namespace lookout::tools {

/// The conditions of a real sea; each is the file tools/scenarios/sea_CONDITION.yaml. docs/sea.md
std::span<const char* const> sea_conditions();

/// Which sea is drawn.
struct SeaSetting {
  std::string condition;                     ///< One of `sea_conditions`.
  std::string targets = "staying";           ///< One of `sea_targets`.
  double p_false_alarm = 0.1, p_miss = 0.1;  ///< Of an empty beam, and of a target in view.
};

/// How targets are drawn: `staying`, evenly over the sector at 40 to 150 m when they come, and there half way
/// to the end too; or `near`, evenly in range from 40 to 80 m when they come, wherever they go. docs/sea.md
std::span<const char* const> sea_targets();

/// The scene of a setting with four targets drawn for the run: 0.8 to 1.3 m/s on any course, two in view at
/// the start, one from 10 s on and one from 20 s on. All conditions of a run have the same targets.
/// @throws core::InputError on targets or a condition of another name.
sonar_sim::Scene sea_scene(const SeaSetting& setting, std::uint64_t seed, int run);

}  // namespace lookout::tools
