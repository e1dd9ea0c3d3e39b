#pragma once

#include "core/sonar_params.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/initiation/initiation_scene.hpp"

namespace lookout::tools {

/// A sonar's scans as an initiator takes them.
struct SonarInitiation {
  InitiationScene scene;    ///< `target_of`: a plot within the 99.9 % gate of the nearest target in view is
                            ///< that target's. Targets count that are in view for a window of 5 s or more.
  core::SonarParams sonar;  ///< As an initiator is told: all figures known.
};

/// One run of a scene of tools/scenarios.
SonarInitiation sonar_initiation(const std::string& scene_file, const SceneVariant& variant,
                                 std::uint64_t seed, int run);

}  // namespace lookout::tools
