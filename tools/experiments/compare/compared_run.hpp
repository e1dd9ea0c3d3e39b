#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sonar_sim/scene.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/cli/sonar_views.hpp"
#include "tools/experiments/compare/curve_score.hpp"

namespace lookout::tools {

/// One sonar of one scene of a comparison.
struct ComparedScene {
  std::string name;        ///< File name without its ending, and vehicle and sonar where there are several.
  std::string file;        ///< As it was given.
  sonar_sim::Scene scene;  ///< Whole.
  SonarView view;          ///< The sonar in it.
};

/// The sonars of all scenes in `files`. @throws core::InputError on scenes that cannot be read or would have
/// one name.
std::vector<ComparedScene> compared_scenes(const std::vector<std::string>& files);

/// One run of a method on a scene, through the whole chain as in `lookout run`, measured at every scan,
/// refused ones included, whose tracks are none.
/// @param configuration with what the tracker is told of the scene's sensor.
/// @param run from 0; (seed, run) alone fix the scans, so that all methods see the same.
Curve compared_run(const ComparedScene& scene, const Configuration& configuration,
                   const CurveScoreParams& params, std::uint64_t seed, int run);

}  // namespace lookout::tools
