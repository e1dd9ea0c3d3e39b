#include "sonar_sim/sea/bottom.hpp"

#include <cmath>
#include <numbers>

namespace lookout::sonar_sim {

double bottom_range(const Bottom& bottom, int beam, int num_beams) {
  return bottom.range + bottom.wave * std::sin(2.0 * std::numbers::pi * bottom.cycles * beam / num_beams);
}

std::vector<BeamReturn> draw_bottom(const Bottom& bottom, const Ping& ping, core::Random& random) {
  std::vector<BeamReturn> heard;
  const int num_beams = ping.params.num_beams;
  for (int beam = 0; beam < num_beams; ++beam) {
    if (!random.bernoulli(bottom.probability)) continue;
    const double range = bottom_range(bottom, beam, num_beams) + random.gaussian(bottom.range_sigma);
    if (ping.in_range(range))
      heard.push_back({beam, {ping.params.beam_centre(beam), range, 1.0}, Source::clutter});
  }
  return heard;
}

}  // namespace lookout::sonar_sim
