#include "sonar_sim/image/image_section.hpp"

#include <optional>

#include "core/sonar_limits.hpp"

namespace lookout::sonar_sim {
namespace {

using core::kNotNegative;
using core::kPositive;
using core::YamlMap;

constexpr core::Range kDecibels{-40, 80};
constexpr core::Range kDepths{0, 60};

GainStripes read_stripes(const YamlMap& map) {
  GainStripes stripes;
  stripes.depth_db = map.number("depth_db", stripes.depth_db, kDepths);
  stripes.width_beams = map.integer("width_beams", stripes.width_beams, {1, core::SonarLimits::kMaxBeams});
  map.finish();
  return stripes;
}

BottomBand read_bottom(const YamlMap& map) {
  BottomBand bottom;
  bottom.range = map.number("range", bottom.range, kPositive);
  bottom.wave = map.number("wave", bottom.wave, kNotNegative);
  bottom.cycles = map.number("cycles", bottom.cycles, {0, 1000});
  bottom.level_db = map.number("level_db", bottom.level_db, kDecibels);
  bottom.extent = map.number("extent", bottom.extent, kPositive);
  map.finish();
  return bottom;
}

ShadowPlan read_shadows(const YamlMap& map) {
  ShadowPlan shadows;
  shadows.depth_db = map.number("depth_db", shadows.depth_db, kDepths);
  shadows.length = map.number("length", shadows.length, kPositive);
  map.finish();
  return shadows;
}

TargetFluctuation read_fluctuation(const YamlMap& map) {
  TargetFluctuation plan;
  plan.swerling = map.integer("swerling", plan.swerling, {0, 4});
  plan.dwell = map.number("dwell", plan.dwell, kPositive);
  if (map.has("dwell") && plan.swerling % 2 == 0)
    map.fail("dwell", "is of cases 1 and 3, expected none: case " + std::to_string(plan.swerling) +
                          (plan.swerling == 0 ? " is steady" : " draws at every ping"));
  map.finish();
  return plan;
}

bool has_things(const StandingPlan& plan) {
  return !plan.points.empty() || !plan.lines.empty() || !plan.arcs.empty() || !plan.fields.empty();
}

ImageSeaPlan read_image_sea(const YamlMap& map, const SonarPlan& sonar) {
  ImageSeaPlan plan;
  plan.correlated_speckle =
      map.choice("speckle", "independent", {"independent", "point_spread"}) == "point_spread";
  if (const auto part = map.map("gain_stripes")) plan.gain_stripes = read_stripes(*part);
  if (const auto part = map.map("bottom")) plan.bottom = read_bottom(*part);
  plan.standing_snr_db = map.optional_number("standing_snr_db", kDecibels);
  if (plan.standing_snr_db && !has_things(sonar.sea.standing))
    map.fail("standing_snr_db", "shows the sea's `standing` things, of which the scene has none");
  if (const auto part = map.map("shadows")) plan.shadows = read_shadows(*part);
  if (plan.shadows && !plan.standing_snr_db)
    map.fail("shadows", "are those of standing things, expected standing_snr_db too");
  if (const auto part = map.map("fluctuation")) plan.fluctuation = read_fluctuation(*part);
  return plan;
}

void check_pixels(const YamlMap& map, const ImagePlan& image, const SonarPlan& sonar) {
  const double pixels = static_cast<double>(image.num_bins) * sonar.params.num_beams;
  if (pixels > core::SonarLimits::kMaxPixels) map.fail("num_bins", "num_beams x num_bins is above 4194304");
}

}  // namespace

ImagePlan read_image(const YamlMap& map, const SonarPlan& sonar) {
  ImagePlan image;
  image.num_bins = map.integer("num_bins", image.num_bins, {1, 30000});
  image.range_step = map.number("range_step", image.range_step, kPositive);
  image.first_range = map.number("first_range", 0.5 * image.range_step, kPositive);
  image.beam_null = core::radians(map.number("beam_null_deg", core::degrees(image.beam_null), kPositive));
  image.tapered = map.choice("beam_taper", "none", {"none", "hann"}) == "hann";
  image.pulse_sigma = map.number("pulse_sigma", image.pulse_sigma, kPositive);
  const std::string background = map.choice("background", "k", {"k", "rayleigh"});
  image.shape = map.number("shape", *image.shape, kPositive);
  if (background == "rayleigh") image.shape.reset();
  image.noise_level = map.number("noise_level", image.noise_level, kPositive);
  image.reverberation_level = map.number("reverberation_level", image.reverberation_level, kNotNegative);
  image.reverberation_range = map.number("reverberation_range", image.reverberation_range, kPositive);
  image.snr_db = map.number("snr_db", image.snr_db, kDecibels);
  image.bits = map.integer("bits", image.bits, {1, 16});
  image.sea = read_image_sea(map, sonar);
  check_pixels(map, image, sonar);
  map.finish();
  return image;
}

}  // namespace lookout::sonar_sim
