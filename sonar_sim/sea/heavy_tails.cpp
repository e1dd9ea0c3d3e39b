#include "sonar_sim/sea/heavy_tails.hpp"

#include <cmath>
#include <random>

namespace lookout::sonar_sim {

void widen(const HeavyTails& plan, std::vector<BeamTarget>& targets, core::Random& random) {
  std::chi_squared_distribution<double> chi_square(plan.degrees_of_freedom);
  for (auto& target : targets) target.noise_scale = std::sqrt(plan.degrees_of_freedom / chi_square(random));
}

}  // namespace lookout::sonar_sim
