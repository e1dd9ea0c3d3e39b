#include "sonar_sim/image/image_maker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/field_of_view.hpp"
#include "sonar_sim/image/acoustic_shadows.hpp"
#include "sonar_sim/image/bottom_band.hpp"
#include "sonar_sim/image/gain_stripes.hpp"
#include "sonar_sim/image/speckle.hpp"
#include "sonar_sim/image/standing_echoes.hpp"

namespace lookout::sonar_sim {
namespace {

constexpr int kMessageBits = 15;  // of a message's integers, their sign apart

core::Random image_stream(const StreamKey& key) {
  return {key.seed, core::RandomStream::images, static_cast<std::uint64_t>(key.platform) * 2 << 40 | key.run};
}

/// The sea's standing things where the image shows them, its fields placed as for the scans.
StandingPlan placed(const SonarPlan& sonar, const ImagePlan& plan, const StreamKey& key) {
  if (!plan.sea.standing_snr_db) return {};
  core::Random places = open_stream(key.of_the_run(), StreamPurpose::places);
  return place_fields(sonar.sea.standing, places);
}

double random_phase(core::Random& random) {
  return random.uniform(0.0, 2.0 * std::numbers::pi);
}

}  // namespace

ImageMaker::ImageMaker(const SonarPlan& sonar, const ImagePlan& plan, const StreamKey& key)
    : sonar_(sonar.params),
      plan_(plan),
      empty_(empty_image(sonar.params, plan)),
      standing_(placed(sonar, plan, key)),
      random_(image_stream(key)),
      standing_random_(open_stream(key, StreamPurpose::image_standing)) {
  if (plan.sea.fluctuation)
    strength_.emplace(*plan.sea.fluctuation, open_stream(key, StreamPurpose::image_fluctuation));
  core::Random stripes = open_stream(key, StreamPurpose::gain_stripes);
  if (plan.sea.gain_stripes) gains_ = draw_gains(*plan.sea.gain_stripes, empty_.num_beams(), stripes);
}

core::SonarImage ImageMaker::draw(const core::Pose2& T_earth_sonar, const core::GroundTruth& truth,
                                  const std::vector<double>& snr_db) {
  core::SonarImage image = empty_;
  image.utime = truth.utime;
  const auto scatterers =
      standing_in_view(standing_, image, T_earth_sonar, plan_.sea.standing_snr_db.value_or(0.0));
  Field field(image.intensity.size());
  add_targets(image, T_earth_sonar, truth, snr_db, field);
  add_standing(image, scatterers, field);
  const std::vector<double> levels = background_levels(image, scatterers);
  const Field speckle = draw_speckle(image, plan_, random_);
  for (std::size_t cell = 0; cell < field.size(); ++cell) field[cell] += levels[cell] * speckle[cell];
  receive(field, image);
  return image;
}

void ImageMaker::add_targets(const core::SonarImage& image, const core::Pose2& T_earth_sonar,
                             const core::GroundTruth& truth, const std::vector<double>& snr_db,
                             Field& field) {
  for (std::size_t i = 0; i < truth.targets.size(); ++i) {
    const core::TargetTruth& target = truth.targets[i];
    const double phase = random_phase(random_);
    const double strength = strength_ ? strength_->amplitude(target.id, core::seconds(truth.utime)) : 1.0;
    if (!target.visible) continue;
    const core::SonarPoint seen = core::observe(sonar_, T_earth_sonar, target.position);
    add_echo(image, plan_, {seen.range, seen.bearing, snr_db[i], phase, strength}, field);
  }
}

void ImageMaker::add_standing(const core::SonarImage& image, std::span<const StandingScatterer> scatterers,
                              Field& field) {
  for (const auto& scatterer : scatterers)
    add_echo(image, plan_,
             {scatterer.range, scatterer.bearing, scatterer.snr_db, random_phase(standing_random_)}, field);
}

std::vector<double> ImageMaker::background_levels(const core::SonarImage& image,
                                                  std::span<const StandingScatterer> scatterers) const {
  std::vector<double> levels;
  levels.reserve(image.intensity.size());
  for (int beam = 0; beam < image.num_beams(); ++beam)
    for (int bin = 0; bin < image.num_bins; ++bin) {
      const double range = image.first_range + bin * image.range_step;
      double level = plan_.background_level(range);
      if (plan_.sea.bottom)
        level = std::hypot(level, bottom_amplitude(*plan_.sea.bottom, plan_, beam, image.num_beams(), range));
      levels.push_back(level);
    }
  if (plan_.sea.shadows) cast_shadows(*plan_.sea.shadows, plan_, image, scatterers, levels);
  return levels;
}

/// Amplitudes with each beam's gain, in the steps of the instrument.
void ImageMaker::receive(const Field& field, core::SonarImage& image) const {
  const auto bins = static_cast<std::size_t>(image.num_bins);
  for (std::size_t cell = 0; cell < field.size(); ++cell)
    image.intensity[cell] = std::abs(field[cell]) * (gains_.empty() ? 1.0 : gains_[cell / bins]);
  core::quantise(image, std::exp2(std::min(plan_.bits, kMessageBits)) - 1.0);
}

}  // namespace lookout::sonar_sim
