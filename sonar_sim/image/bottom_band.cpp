#include "sonar_sim/image/bottom_band.hpp"

#include <cmath>
#include <numbers>

namespace lookout::sonar_sim {

double bottom_amplitude(const BottomBand& bottom, const ImagePlan& plan, int beam, int num_beams,
                        double range) {
  const double turn = 2.0 * std::numbers::pi * bottom.cycles * beam / num_beams;
  const double begin = bottom.range + bottom.wave * std::sin(turn);
  if (range < begin) return 0.0;
  return plan.background_level(begin) * std::pow(10.0, bottom.level_db / 20.0) *
         std::exp(-(range - begin) / bottom.extent);
}

}  // namespace lookout::sonar_sim
