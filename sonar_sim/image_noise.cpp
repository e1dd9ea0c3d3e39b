#include "sonar_sim/image_noise.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "core/field_of_view.hpp"

namespace lookout::sonar_sim {
namespace {

using Field = std::vector<std::complex<double>>;

// The visible targets as an image shows them; each target of the truth takes its draw, seen or not.
std::vector<ImageTarget> image_targets(const core::SonarParams& sonar, const core::Pose2& T_earth_sonar,
                                       const core::GroundTruth& truth, const std::vector<double>& snr_db,
                                       core::Random& random) {
  std::vector<ImageTarget> targets;
  for (std::size_t i = 0; i < truth.targets.size(); ++i) {
    const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
    if (!truth.targets[i].visible) continue;
    const core::SonarPoint seen = core::observe(sonar, T_earth_sonar, truth.targets[i].position);
    targets.push_back({seen.range, seen.bearing, snr_db[i], phase});
  }
  return targets;
}

}  // namespace

std::complex<double> draw_background(const std::optional<double>& shape, core::Random& random) {
  double texture = 1.0;
  if (shape) texture = std::gamma_distribution<double>(*shape, 1.0 / *shape)(random);
  const double sigma = std::sqrt(0.5 * texture);
  return {random.gaussian(sigma), random.gaussian(sigma)};
}

core::SonarImage draw_image(const core::SonarParams& sonar, const ImagePlan& plan,
                            const core::Pose2& T_earth_sonar, const core::GroundTruth& truth,
                            const std::vector<double>& snr_db, core::Random& random) {
  core::SonarImage image = empty_image(sonar, plan);
  image.utime = truth.utime;
  Field field(image.intensity.size());
  for (const ImageTarget& target : image_targets(sonar, T_earth_sonar, truth, snr_db, random))
    add_echo(image, plan, target, field);
  std::size_t cell = 0;
  for (int beam = 0; beam < image.num_beams(); ++beam)
    for (int bin = 0; bin < image.num_bins; ++bin, ++cell) {
      const double level = plan.background_level(image.first_range + bin * image.range_step);
      image.intensity[cell] = std::abs(field[cell] + level * draw_background(plan.shape, random));
    }
  return image;
}

}  // namespace lookout::sonar_sim
