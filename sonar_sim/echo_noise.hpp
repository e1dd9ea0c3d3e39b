#pragma once

#include <vector>

#include "core/random.hpp"
#include "sonar_sim/beam_model.hpp"
#include "sonar_sim/ping.hpp"

/// Echoes and false alarms of the paper's sea: uniform, independent, nothing but targets.
namespace lookout::sonar_sim {

/// The echoes of a beam sonar: of each owner with 1 - P_M, its range with a Gaussian error. [Yan2018]
/// section V, with the probabilities conditional on the beam's content.
/// @param owners of the beams, as `beam_owners` gives them.
std::vector<BeamReturn> draw_beam_echoes(const Ping& ping, const std::vector<BeamTarget>& owners,
                                         core::Random& random);

/// The false alarms of a beam sonar, in the slots (`returns_per_beam` a beam) that no target owns.
/// @param num_visible how many targets are visible, occluded ones counted (light clutter is in proportion to
///   it).
std::vector<BeamReturn> draw_beam_clutter(const Ping& ping, const std::vector<BeamTarget>& owners,
                                          int num_visible, core::Random& random);

/// The echoes of a point sensor: of each visible target with 1 - P_M, range and bearing with Gaussian errors.
std::vector<BeamReturn> draw_point_echoes(const Ping& ping, const std::vector<BeamTarget>& visible,
                                          core::Random& random);

/// The false alarms of a point sensor: a Poisson number, uniform in range and bearing.
std::vector<BeamReturn> draw_point_clutter(const Ping& ping, core::Random& random);

}  // namespace lookout::sonar_sim
