#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "core/beam_bearings.hpp"
#include "core/sonar_image.hpp"

namespace lookout::testing {

/// Echo of a point in an image of speckle.
struct PointEcho {
  double beam = 0.0, bin = 0.0;  ///< Where, in beams and bins from the first ones' centres.
  double snr_db = 20.0;          ///< Of its top over the mean power of the speckle there.
};

/// What the images are drawn from.
struct SpecklePlan {
  int num_beams = 96, num_bins = 512;
  std::optional<double> shape;  ///< Of K-distributed speckle; absent: Rayleigh.
  double stripe_db = 0.0;       ///< Gain from beam to beam: uniform within so many dB to either side.
  double fall_db = 0.0;         ///< How much the level falls from the first bin to the last.
  double wide_beams = 1.0;      ///< Half-power extent of an echo; the speckle has the same grain
  double long_bins = 1.0;       ///< where `grainy`, else its cells are independent.
  bool grainy = false;
  double first_bearing = -0.5, bearing_step = 0.01;  ///< [rad]
  double first_range = 2.0, range_step = 0.1;        ///< [m]
};

/// Draws amplitude images of speckle and echoes, one after the other, the same for the same seed. Echoes are
/// Gaussian in both directions and added as complex amplitudes of a phase of their own.
class SpeckleImages {
 public:
  SpeckleImages(const SpecklePlan& plan, std::uint32_t seed) : plan_(plan), random_(seed) {
    for (int beam = 0; beam < plan.num_beams; ++beam) {
      const double db = std::uniform_real_distribution<>(-plan.stripe_db, plan.stripe_db)(random_);
      gain_.push_back(std::pow(10.0, db / 20.0));
    }
  }

  core::SonarImage next(const std::vector<PointEcho>& echoes = {}) {
    draw_speckle();
    for (const auto& echo : echoes) add(echo);
    core::SonarImage image = describe();
    for (std::size_t cell = 0; cell < field_.size(); ++cell) {
      const auto beam = cell / static_cast<std::size_t>(plan_.num_bins);
      const double share =
          static_cast<double>(cell % static_cast<std::size_t>(plan_.num_bins)) / plan_.num_bins;
      image.intensity.push_back(gain_[beam] * std::pow(10.0, -plan_.fall_db * share / 20.0) *
                                std::abs(field_[cell]));
    }
    return image;
  }

 private:
  using Field = std::vector<std::complex<double>>;

  core::SonarImage describe() {
    core::SonarImage image;
    image.utime = 500'000 * static_cast<std::int64_t>(sequence_);
    image.sequence = sequence_++;
    image.bearings = core::even_bearings(plan_.first_bearing, plan_.bearing_step, plan_.num_beams);
    image.first_range = plan_.first_range;
    image.range_step = plan_.range_step;
    image.num_bins = plan_.num_bins;
    image.intensity.reserve(field_.size());
    return image;
  }

  /// Amplitude of an echo so far off, in half-power extents: its power is one half at half an extent.
  static double response(double extents) { return std::exp2(-2.0 * extents * extents); }

  void draw_speckle() {
    std::normal_distribution<double> normal(0.0, std::numbers::sqrt2 / 2.0);
    field_.resize(static_cast<std::size_t>(plan_.num_beams) * static_cast<std::size_t>(plan_.num_bins));
    for (auto& value : field_) value = {normal(random_), normal(random_)};
    if (plan_.grainy) {
      blur(plan_.long_bins, 1, plan_.num_bins);
      blur(plan_.wide_beams, plan_.num_bins, plan_.num_beams);
    }
    if (!plan_.shape) return;
    std::gamma_distribution<double> texture(*plan_.shape, 1.0 / *plan_.shape);
    for (auto& value : field_) value *= std::sqrt(texture(random_));
  }

  /// Along one direction of the field, the power kept.
  void blur(double extent, int stride, int size) {
    const int reach = static_cast<int>(std::ceil(1.5 * extent));
    std::vector<double> weights;
    double power = 0.0;
    for (int i = -reach; i <= reach; ++i) {
      weights.push_back(response(i / extent));
      power += weights.back() * weights.back();
    }
    const Field old = field_;
    const auto cells = static_cast<int>(field_.size());
    for (int cell = 0; cell < cells; ++cell) {
      const int place = cell / stride % size;
      std::complex<double> sum = 0.0;
      for (int i = -reach; i <= reach; ++i) {
        const int other = (place + i + size) % size;  // Round the edge, so that the power is the same there.
        sum += weights[static_cast<std::size_t>(i + reach)] *
               old[static_cast<std::size_t>(cell + (other - place) * stride)];
      }
      field_[static_cast<std::size_t>(cell)] = sum / std::sqrt(power);
    }
  }

  void add(const PointEcho& echo) {
    const double phase = std::uniform_real_distribution<>(0.0, 2.0 * std::numbers::pi)(random_);
    const std::complex<double> top = std::polar(std::pow(10.0, echo.snr_db / 20.0), phase);
    for (int beam = 0; beam < plan_.num_beams; ++beam) {
      const std::complex<double> in_beam = top * response((beam - echo.beam) / plan_.wide_beams);
      if (std::abs(in_beam) < 1e-3) continue;
      for (int bin = 0; bin < plan_.num_bins; ++bin)
        field_[static_cast<std::size_t>(beam) * static_cast<std::size_t>(plan_.num_bins) +
               static_cast<std::size_t>(bin)] += in_beam * response((bin - echo.bin) / plan_.long_bins);
    }
  }

  SpecklePlan plan_;
  std::mt19937 random_;
  std::vector<double> gain_;  ///< Amplitude, by beam.
  Field field_;
  std::int64_t sequence_ = 0;
};

}  // namespace lookout::testing
