#pragma once

#include <complex>
#include <vector>

#include "core/random.hpp"
#include "core/sonar_image.hpp"
#include "sonar_sim/image_model.hpp"

namespace lookout::sonar_sim {

/// The background of an image before its level: complex samples laid out like its intensity, of rms 1,
/// K-distributed or Rayleigh as the plan says. Independent from cell to cell, or, where
/// plan.sea.correlated_speckle, what white scatterers give through the point spread: neighbours in range
/// correlate by the pulse, neighbours in bearing by the beam pattern, whatever the sizes of the cells.
std::vector<std::complex<double>> draw_speckle(const core::SonarImage& image, const ImagePlan& plan,
                                               core::Random& random);

}  // namespace lookout::sonar_sim
