#include "tracking/detection/gain_background.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/parameter_check.hpp"
#include "csht/likelihood/fast_math.hpp"

namespace lookout::tracking {
namespace {

// Share of a range's mean power that is added to every cell there, so that a silent cell has a logarithm: -30
// dB.
constexpr double kFloor = 1e-3;
constexpr double kLeastPower = 1e-30;
constexpr double kNepersPerDecibel = std::numbers::ln10 / 10.0;
// Speckle alone makes the learnt structure of a cell deviate by the square root of the learning step
// [nepers]. What is below so many such deviations counts as no structure.
constexpr float kSureSigmas = 3.0F;
constexpr double kFirstPings = 2.0;  // The structure begins at 0 with the weight of so many pings.

double power(ImageValues values, double value) {
  if (values == ImageValues::decibel) return std::exp(kNepersPerDecibel * value);
  return values == ImageValues::amplitude ? value * value : value;
}

}  // namespace

GainBackground::GainBackground(const BackgroundParams& params, ImageValues values)
    : params_(params), values_(values) {
  core::require(params.memory_pings == 0.0 || params.memory_pings >= 1.0,
                "background memory_pings must be 0 or >= 1", params.memory_pings);
  core::require_positive("pull", params.pull);
}

ImagePlane& GainBackground::normalise(const std::vector<double>& intensity, int num_beams, int num_bins) {
  if (num_beams != log_.num_beams || num_bins != log_.num_bins) forget();
  for (ImagePlane* plane : {&log_, &structure_, &normalised_}) plane->resize(num_beams, num_bins);
  if (pings_ == 0) std::fill(structure_.values.begin(), structure_.values.end(), 0.0F);
  take_logarithms(intensity);
  fit_gain_and_level();
  divide();
  ++pings_;
  return normalised_;
}

/// Logarithms of power above a floor that follows the mean level of each range.
void GainBackground::take_logarithms(const std::vector<double>& intensity) {
  const auto bins = static_cast<std::size_t>(log_.num_bins);
  bin_sums_.assign(bins, 0.0);
  std::size_t cell = 0;
  for (int beam = 0; beam < log_.num_beams; ++beam)
    for (std::size_t bin = 0; bin < bins; ++bin, ++cell) {
      const double value = power(values_, intensity[cell]);
      log_.values[cell] = static_cast<float>(value);
      bin_sums_[bin] += value;
    }
  level_.resize(bins);
  for (std::size_t bin = 0; bin < bins; ++bin)
    level_[bin] = static_cast<float>(std::max(kLeastPower, kFloor * bin_sums_[bin] / log_.num_beams));
  for (int beam = 0; beam < log_.num_beams; ++beam) {
    const auto row = log_.row(beam);
    for (std::size_t bin = 0; bin < bins; ++bin) row[bin] = csht::fast_log(row[bin] + level_[bin]);
  }
}

void GainBackground::fit_gain_and_level() {
  const auto bins = static_cast<std::size_t>(log_.num_bins);
  bin_sums_.assign(bins, 0.0);
  gain_.resize(static_cast<std::size_t>(log_.num_beams));
  for (int beam = 0; beam < log_.num_beams; ++beam) {
    const auto row = log_.row(beam);
    gain_[static_cast<std::size_t>(beam)] =
        std::accumulate(row.begin(), row.end(), 0.0F) / static_cast<float>(bins);
    for (std::size_t bin = 0; bin < bins; ++bin) bin_sums_[bin] += row[bin];
  }
  const double mean = std::accumulate(gain_.begin(), gain_.end(), 0.0) / log_.num_beams;
  for (std::size_t bin = 0; bin < bins; ++bin)
    level_[bin] = static_cast<float>(bin_sums_[bin] / log_.num_beams - mean);
}

void GainBackground::divide() {
  const bool learns = params_.memory_pings > 0.0;
  const auto step = static_cast<float>(1.0 / std::min(params_.memory_pings, pings_ + kFirstPings));
  for (int beam = 0; beam < log_.num_beams; ++beam)
    learns ? divide_row<true>(beam, step) : divide_row<false>(beam, step);
}

template <bool kLearns>
void GainBackground::divide_row(int beam, float step) {
  const auto row = log_.row(beam);
  const auto structure = structure_.row(beam);
  const auto normalised = normalised_.row(beam);
  const float gain = gain_[static_cast<std::size_t>(beam)];
  const float doubt = kSureSigmas * std::sqrt(step);
  const auto pull = static_cast<float>(params_.pull);
  for (std::size_t bin = 0; bin < row.size(); ++bin) {
    const float excess = row[bin] - gain - level_[bin];
    if constexpr (!kLearns) {
      normalised[bin] = csht::fast_exp(excess);
    } else {
      normalised[bin] = csht::fast_exp(excess - std::max(0.0F, structure[bin] - doubt));
      structure[bin] += step * std::clamp(excess - structure[bin], -pull, pull);
    }
  }
}

}  // namespace lookout::tracking
