#pragma once

#include <vector>

#include "core/random.hpp"
#include "sonar_sim/beam_model.hpp"

namespace lookout::sonar_sim {

/// Range errors of Student's t in place of the Gaussian: sigma t, so that the standard deviation is
/// sigma sqrt(nu / (nu - 2)) where nu > 2 and infinite below.
struct HeavyTails {
  double degrees_of_freedom = 3.0;  ///< nu, > 0.
};

/// Draws the factor of each target's Gaussian error, sqrt(nu / V) with V chi-square of nu degrees of freedom.
void widen(const HeavyTails& plan, std::vector<BeamTarget>& targets, core::Random& random);

}  // namespace lookout::sonar_sim
