#include "csht/spatial_correlation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

double residual(const Line& line, const LineSample& sample, double time) {
  return std::abs(sample.position - line.intercept - line.velocity * (sample.time - time));
}

}  // namespace

SpatialCorrelation::SpatialCorrelation(const SpatialCorrelationParams& params, double range_sigma,
                                       SingleLine single_line)
    : params_(params), range_sigma_(range_sigma), single_line_(std::move(single_line)) {
  core::require(params.gate > 0.0, "gate must be > 0", params.gate);
  core::require(params.max_lines >= 1, "max_lines must be > 0", params.max_lines);
  core::require(params.min_samples >= 1, "min_samples must be > 0", params.min_samples);
}

std::span<const Line> SpatialCorrelation::second_lines(const Line& first, std::span<const LineSample> along,
                                                       std::span<const LineSample> across, double time,
                                                       double centre) {
  gated_.clear();
  for (std::size_t k = 0; k < along.size(); ++k) {
    if (residual(first, along[k], time) < gate_of(along[k])) gated_.push_back(across[k]);
  }
  lines_.clear();
  while (static_cast<int>(lines_.size()) < params_.max_lines &&
         static_cast<int>(gated_.size()) >= params_.min_samples) {
    const auto line = single_line_.extract(gated_, time, centre);
    if (!line) break;
    lines_.push_back(*line);
    leave_samples_of(*line, time);
  }
  return lines_;
}

/// A coarse bearing can make a line sample's error along the axis larger than the range sigma.
double SpatialCorrelation::gate_of(const LineSample& sample) const {
  return params_.gate * std::max(range_sigma_, sample.sigma);
}

void SpatialCorrelation::leave_samples_of(const Line& line, double time) {
  std::erase_if(gated_,
                [&](const LineSample& sample) { return residual(line, sample, time) < gate_of(sample); });
}

}  // namespace lookout::csht
