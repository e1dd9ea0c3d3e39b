#pragma once

#include <vector>

#include "core/random.hpp"
#include "core/sonar_scan.hpp"
#include "sonar_sim/beam_model.hpp"
#include "sonar_sim/scene.hpp"

namespace lookout::sonar_sim {

/// What a beam sonar returns in one scan: at most one echo a beam, in order of beam. [Yan2018] section V,
/// with the probabilities conditional on the beam's content.
/// @param owners of the beams, as `beam_owners` gives them.
/// @param num_visible how many targets are visible, occluded ones counted (light clutter is in proportion to
/// it).
std::vector<core::SonarReturn> draw_beam_returns(const SonarPlan& sonar,
                                                 const std::vector<BeamTarget>& owners, int num_visible,
                                                 core::Random& random);

/// What a point sensor returns: each visible target with 1 - P_M, range and bearing with Gaussian errors,
/// then Poisson clutter uniform in range and bearing.
std::vector<core::SonarReturn> draw_point_returns(const SonarPlan& sonar,
                                                  const std::vector<BeamTarget>& visible,
                                                  core::Random& random);

}  // namespace lookout::sonar_sim
