#include "tracking/detection/speckle_grain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace lookout::tracking {
namespace {

constexpr int kLags = 32;      // Longest distance that is looked at [cells].
constexpr int kStride = 8;     // Of the beams that are looked at.
constexpr double kFade = 0.9;  // Weight of the earlier pings at each new one: about ten count.
constexpr float kBrightest =
    4.0F;  // Brighter cells are taken for this bright, lest a target pass for speckle.

/// Sum of products of two rows about `mean`, the second `lag` cells on.
double product(std::span<const float> a, std::span<const float> b, std::size_t lag, float mean) {
  double sum = 0.0;
  for (std::size_t i = 0; i + lag < a.size(); ++i)
    sum += (std::min(a[i], kBrightest) - mean) * (std::min(b[i + lag], kBrightest) - mean);
  return sum / static_cast<double>(a.size() - lag);
}

/// Where the correlation above its value at the longest lag has fallen to one half [cells].
double half_way(const std::vector<double>& correlation) {
  if (correlation.empty()) return 0.0;
  const double pedestal = correlation.back();
  const double half = 0.5 * (correlation.front() - pedestal);
  for (std::size_t lag = 1; lag < correlation.size(); ++lag) {
    const double here = correlation[lag] - pedestal, before = correlation[lag - 1] - pedestal;
    if (here < half) return static_cast<double>(lag - 1) + (before - half) / (before - here);
  }
  return static_cast<double>(correlation.size() - 1);
}

double extent_of(const std::vector<double>& correlation) {
  return std::max(1.0, std::numbers::sqrt2 * half_way(correlation));
}

}  // namespace

void SpeckleGrain::forget() {
  over_beams_.clear();
  along_range_.clear();
}

void SpeckleGrain::begin(const ImagePlane& plane) {
  const auto lags = [](int size) { return static_cast<std::size_t>(std::clamp(size / 2, 1, kLags)); };
  over_beams_.resize(lags(plane.num_beams));
  along_range_.resize(lags(plane.num_bins));
  for (auto* sums : {&over_beams_, &along_range_})
    for (double& sum : *sums) sum *= kFade;
}

float SpeckleGrain::mean_excess(const ImagePlane& plane) const {
  double sum = 0.0;
  for (int beam = 0; beam < plane.num_beams; beam += kStride)
    for (const float value : plane.row(beam)) sum += std::min(value, kBrightest);
  const int rows = (plane.num_beams + kStride - 1) / kStride;
  return static_cast<float>(sum / (static_cast<double>(rows) * plane.num_bins));
}

void SpeckleGrain::add(const ImagePlane& plane) {
  begin(plane);
  const float mean = mean_excess(plane);
  const int last_beams = static_cast<int>(over_beams_.size()) - 1;
  for (int beam = 0; beam < plane.num_beams; beam += kStride) {
    const auto row = plane.row(beam);
    for (std::size_t lag = 0; lag < along_range_.size(); ++lag)
      along_range_[lag] += product(row, row, lag, mean);
    if (beam + last_beams >= plane.num_beams) continue;
    for (std::size_t lag = 0; lag < over_beams_.size(); ++lag)
      over_beams_[lag] += product(row, plane.row(beam + static_cast<int>(lag)), 0, mean);
  }
}

EchoExtent SpeckleGrain::extent() const {
  return {extent_of(over_beams_), extent_of(along_range_)};
}

}  // namespace lookout::tracking
