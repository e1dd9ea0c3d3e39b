#pragma once

#include "sonar_sim/image_model.hpp"

namespace lookout::sonar_sim {

/// rms amplitude of the bottom alone in a beam at `range` [m]: 0 before the bottom's range R, behind it
/// level(R) 10^(level_db / 20) exp(-(range - R) / extent), R = range + wave sin(2 pi cycles beam /
/// num_beams).
double bottom_amplitude(const BottomBand& bottom, const ImagePlan& plan, int beam, int num_beams,
                        double range);

}  // namespace lookout::sonar_sim
