#include "sonar_sim/image/speckle.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace lookout::sonar_sim {
namespace {

using Field = std::vector<std::complex<double>>;

constexpr double kPulseReach = 4.0;    // standard deviations; beyond, the pulse is below 4e-4
constexpr double kPatternReach = 4.0;  // first nulls of the beam pattern
const double kHalf = std::sqrt(0.5);   // of each part of a complex sample of power 1

double draw_texture(const ImagePlan& plan, core::Random& random) {
  if (!plan.shape) return 1.0;
  return std::gamma_distribution<double>(*plan.shape, 1.0 / *plan.shape)(random);
}

/// Scales the weights to a sum of squares of 1, so that white noise keeps its power.
void keep_power(std::vector<double>& weights) {
  double power = 0.0;
  for (const double weight : weights) power += weight * weight;
  for (double& weight : weights) weight /= std::sqrt(power);
}

/// Through the pulse, along each beam. The scatterers go on beyond both ends as their mirror image.
void filter_ranges(const core::SonarImage& image, const ImagePlan& plan, Field& field) {
  const int reach = static_cast<int>(std::floor(kPulseReach * plan.pulse_sigma / image.range_step));
  std::vector<double> weights;
  for (int k = -reach; k <= reach; ++k) weights.push_back(pulse_response(plan, k * image.range_step));
  keep_power(weights);
  const int bins = image.num_bins;
  const auto mirrored = [bins](int bin) {
    if (bin < 0) bin = -bin - 1;
    bin %= 2 * bins;
    return bin < bins ? bin : 2 * bins - 1 - bin;
  };
  Field beam(static_cast<std::size_t>(bins));
  for (int first = 0; first < static_cast<int>(field.size()); first += bins) {
    std::copy_n(field.begin() + first, bins, beam.begin());
    for (int bin = 0; bin < bins; ++bin) {
      std::complex<double> sum = 0.0;
      for (int k = -reach; k <= reach; ++k)
        sum +=
            weights[static_cast<std::size_t>(k + reach)] * beam[static_cast<std::size_t>(mirrored(bin + k))];
      field[static_cast<std::size_t>(first + bin)] = sum;
    }
  }
}

/// Through the beam pattern: each beam hears the scatterers at the bearings of its neighbours.
void filter_bearings(const core::SonarImage& image, const ImagePlan& plan, Field& field) {
  const Field scatterers = field;
  const auto bins = static_cast<std::size_t>(image.num_bins);
  std::fill(field.begin(), field.end(), std::complex<double>(0.0));
  for (std::size_t beam = 0; beam < image.bearings.size(); ++beam) {
    std::vector<std::size_t> heard;
    std::vector<double> weights;
    for (std::size_t other = 0; other < image.bearings.size(); ++other) {
      const double off = image.bearings[other] - image.bearings[beam];
      if (std::abs(off) > kPatternReach * plan.beam_null) continue;
      heard.push_back(other);
      weights.push_back(beam_response(plan, off));
    }
    keep_power(weights);
    for (std::size_t k = 0; k < heard.size(); ++k)
      for (std::size_t bin = 0; bin < bins; ++bin)
        field[beam * bins + bin] += weights[k] * scatterers[heard[k] * bins + bin];
  }
}

}  // namespace

std::vector<std::complex<double>> draw_speckle(const core::SonarImage& image, const ImagePlan& plan,
                                               core::Random& random) {
  Field field(image.intensity.size());
  std::vector<double> texture(field.size());
  for (std::size_t cell = 0; cell < field.size(); ++cell) {
    texture[cell] = std::sqrt(draw_texture(plan, random));
    const double real = random.gaussian(kHalf), imaginary = random.gaussian(kHalf);
    field[cell] = {real, imaginary};
  }
  if (plan.sea.correlated_speckle) {
    filter_ranges(image, plan, field);
    filter_bearings(image, plan, field);
  }
  for (std::size_t cell = 0; cell < field.size(); ++cell) field[cell] *= texture[cell];
  return field;
}

}  // namespace lookout::sonar_sim
