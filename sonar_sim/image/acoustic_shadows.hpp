#pragma once

#include <span>
#include <vector>

#include "core/sonar_image.hpp"
#include "sonar_sim/image/standing_echoes.hpp"
#include "sonar_sim/image_model.hpp"

namespace lookout::sonar_sim {

/// Lowers the background's levels, laid out like the image's intensity, behind each scatterer: from one pulse
/// behind it on, in the beams whose centres lie within half the first null of it, to the plan's length or, of
/// a wall, to the end. What several things shade is no darker than what one does.
void cast_shadows(const ShadowPlan& shadows, const ImagePlan& plan, const core::SonarImage& image,
                  std::span<const StandingScatterer> scatterers, std::vector<double>& levels);

}  // namespace lookout::sonar_sim
