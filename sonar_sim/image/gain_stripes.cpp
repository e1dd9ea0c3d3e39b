#include "sonar_sim/image/gain_stripes.hpp"

#include <cmath>

namespace lookout::sonar_sim {

std::vector<double> draw_gains(const GainStripes& plan, int num_beams, core::Random& random) {
  std::vector<double> gains;
  for (int beam = 0; beam < num_beams; ++beam) {
    if (beam % plan.width_beams == 0)
      gains.push_back(std::pow(10.0, random.uniform(-0.5 * plan.depth_db, 0.5 * plan.depth_db) / 20.0));
    else
      gains.push_back(gains.back());
  }
  return gains;
}

}  // namespace lookout::sonar_sim
