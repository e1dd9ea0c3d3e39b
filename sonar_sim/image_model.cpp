#include "sonar_sim/image_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/beam_bearings.hpp"
#include "core/parameter_check.hpp"

namespace lookout::sonar_sim {
namespace {

constexpr double kNearPole = 1e-9;

double sinc(double u) {
  const double x = std::numbers::pi * u;
  return std::abs(x) < 1e-9 ? 1.0 : std::sin(x) / x;
}

constexpr double kPulseReach = 5.0;  // standard deviations; beyond, the pulse is below 4e-6

}  // namespace

double ImagePlan::background_level(double range) const {
  return noise_level + reverberation_level / (1.0 + range / reverberation_range);
}

void check(const ImagePlan& plan) {
  core::require_positive("num_bins", plan.num_bins);
  core::require_positive("first_range", plan.first_range);
  core::require_positive("range_step", plan.range_step);
  core::require_positive("beam_null", plan.beam_null);
  core::require_positive("pulse_sigma", plan.pulse_sigma);
  core::require_positive("shape", plan.shape.value_or(1.0));
  core::require_positive("noise_level", plan.noise_level);
  core::require_positive("reverberation_range", plan.reverberation_range);
  core::require(plan.bits >= 1 && plan.bits <= 16, "bits must be 1 to 16", plan.bits);
  core::require_not_negative("reverberation_level", plan.reverberation_level);
}

core::SonarImage empty_image(const core::SonarParams& sonar, const ImagePlan& plan) {
  check(plan);
  core::SonarImage image;
  image.T_body_sonar = sonar.T_body_sonar;
  if (sonar.fan)
    image.bearings.assign(sonar.fan->bearings().begin(), sonar.fan->bearings().end());
  else
    image.bearings = core::even_bearings(sonar.first_bearing, sonar.bearing_step, sonar.num_beams);
  image.first_range = plan.first_range;
  image.range_step = plan.range_step;
  image.num_bins = plan.num_bins;
  image.intensity.assign(static_cast<std::size_t>(sonar.num_beams) * static_cast<std::size_t>(plan.num_bins),
                         0.0);
  return image;
}

double beam_response(const ImagePlan& plan, double bearing) {
  const double u = bearing / plan.beam_null;
  if (!plan.tapered) return sinc(u);
  const double pole = 1.0 - 4.0 * u * u;
  return std::abs(pole) < kNearPole ? 0.5 : sinc(2.0 * u) / pole;  // The limit there.
}

double pulse_response(const ImagePlan& plan, double range) {
  const double u = range / plan.pulse_sigma;
  return std::exp(-0.5 * u * u);
}

void add_echo(const core::SonarImage& image, const ImagePlan& plan, const ImageTarget& target,
              std::vector<std::complex<double>>& field) {
  const double peak =
      target.strength * plan.background_level(target.range) * std::pow(10.0, target.snr_db / 20.0);
  const std::complex<double> echo = std::polar(peak, target.phase);
  const double reach = kPulseReach * plan.pulse_sigma;
  const auto bin_of = [&](double range) { return (range - image.first_range) / image.range_step; };
  const int first = std::max(0, static_cast<int>(std::ceil(bin_of(target.range - reach))));
  const int last = std::min(image.num_bins - 1, static_cast<int>(std::floor(bin_of(target.range + reach))));
  for (int beam = 0; beam < image.num_beams(); ++beam) {
    const double off = core::wrap_to_pi(image.bearings[static_cast<std::size_t>(beam)] - target.bearing);
    const std::complex<double> in_beam = echo * beam_response(plan, off);
    for (int bin = first; bin <= last; ++bin) {
      const double range = image.first_range + bin * image.range_step;
      field[static_cast<std::size_t>(beam * image.num_bins + bin)] +=
          in_beam * pulse_response(plan, range - target.range);
    }
  }
}

}  // namespace lookout::sonar_sim
