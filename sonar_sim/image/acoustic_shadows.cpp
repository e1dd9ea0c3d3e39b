#include "sonar_sim/image/acoustic_shadows.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::sonar_sim {
namespace {

/// Bins [first, last) of the shadow in a beam.
struct Shade {
  int first, last;
};

Shade shade_behind(const StandingScatterer& scatterer, const ShadowPlan& shadows, const ImagePlan& plan,
                   const core::SonarImage& image) {
  const auto bin_of = [&image](double range) {
    const double bin = std::ceil((range - image.first_range) / image.range_step);
    return static_cast<int>(std::clamp(bin, 0.0, static_cast<double>(image.num_bins)));
  };
  const double begin = scatterer.range + 2.0 * plan.pulse_sigma;
  return {bin_of(begin), scatterer.is_wall ? image.num_bins : bin_of(begin + shadows.length)};
}

}  // namespace

void cast_shadows(const ShadowPlan& shadows, const ImagePlan& plan, const core::SonarImage& image,
                  std::span<const StandingScatterer> scatterers, std::vector<double>& levels) {
  std::vector<char> shaded(levels.size(), 0);
  const auto bins = static_cast<std::size_t>(image.num_bins);
  for (const auto& scatterer : scatterers) {
    const Shade shade = shade_behind(scatterer, shadows, plan, image);
    for (std::size_t beam = 0; beam < image.bearings.size(); ++beam) {
      if (std::abs(core::wrap_to_pi(image.bearings[beam] - scatterer.bearing)) > 0.5 * plan.beam_null)
        continue;
      const auto row = shaded.begin() + static_cast<std::ptrdiff_t>(beam * bins);
      if (shade.first < shade.last) std::fill(row + shade.first, row + shade.last, 1);
    }
  }
  const double factor = std::pow(10.0, -shadows.depth_db / 20.0);
  for (std::size_t cell = 0; cell < levels.size(); ++cell)
    if (shaded[cell] != 0) levels[cell] *= factor;
}

}  // namespace lookout::sonar_sim
