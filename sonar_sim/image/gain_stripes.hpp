#pragma once

#include <vector>

#include "core/random.hpp"
#include "sonar_sim/image/image_sea_plan.hpp"

namespace lookout::sonar_sim {

/// The factor of each beam's amplitude, fixed for a sonar: of each stripe of beams one, uniform in decibels.
std::vector<double> draw_gains(const GainStripes& plan, int num_beams, core::Random& random);

}  // namespace lookout::sonar_sim
