#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "core/ground_truth.hpp"
#include "core/random.hpp"
#include "core/sonar_image.hpp"
#include "sonar_sim/image_model.hpp"

namespace lookout::sonar_sim {

/// A complex sample whose amplitude is K-distributed with rms 1: Rayleigh speckle on gamma-distributed
/// texture of the given shape; Rayleigh where shape is absent. [Jakeman1976]
std::complex<double> draw_background(const std::optional<double>& shape, core::Random& random);

/// Draws the image of a scene's visible targets: echoes with a uniform phase at each ping, added as complex
/// amplitudes to a background that is independent from cell to cell and ping to ping.
/// @param snr_db of each target of `truth`, in its order.
core::SonarImage draw_image(const core::SonarParams& sonar, const ImagePlan& plan,
                            const core::Pose2& T_earth_sonar, const core::GroundTruth& truth,
                            const std::vector<double>& snr_db, core::Random& random);

}  // namespace lookout::sonar_sim
