#include "tracking/joint/heading_correction.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "csht/likelihood/sensor_likelihood.hpp"

namespace lookout::tracking {

void HeadingCorrection::refine(TrackerState& state) {
  if (const auto error = find(state.tracks, state.scans())) state.likelihood.set_heading_error(0, *error);
}

std::optional<csht::HeadingError> HeadingCorrection::find(std::span<const csht::TargetTrack> tracks,
                                                          const csht::ScanHistory& scans) {
  const csht::SensorFigures& figures = scans.figures();
  const double prior = figures.heading_sigma;
  if (prior <= 0.0 || scans.model().clutter == csht::ClutterModel::point) return std::nullopt;
  const auto telling =
      std::count_if(tracks.begin(), tracks.end(), [this](const csht::TargetTrack& t) { return tells(t); });
  if (telling < 2) return std::nullopt;
  table_ = scans.newest();
  const double step = params_.reach_sigmas * prior / params_.steps;
  log_weight_.clear();
  for (int k = -params_.steps; k <= params_.steps; ++k) {
    const double error = k * step;
    csht::set_heading_error({error, 0.0}, figures, table_);
    log_weight_.push_back(log_likelihood(tracks) - 0.5 * error * error / (prior * prior));
  }
  return moments(step);
}

csht::HeadingError HeadingCorrection::moments(double step) {
  weight_.resize(log_weight_.size());
  csht::normalise_log_weights(log_weight_, weight_);
  double mean = 0.0, square = 0.0;
  for (int k = -params_.steps; k <= params_.steps; ++k) {
    const double weight = weight_[static_cast<std::size_t>(k + params_.steps)];
    mean += weight * k * step;
    square += weight * k * step * k * step;
  }
  return {mean, std::sqrt(std::max(0.0, square - mean * mean) + step * step / 12.0)};
}

bool HeadingCorrection::tells(const csht::TargetTrack& track) const {
  return track.used && !track.out_of_view && track.existence() >= params_.least_existence;
}

// The heading will be used to update each track, whose own return has helped to find it: its information must
// not count twice. The share of one of n targets is taken out, by the factor (n - 1) / n; n is their expected
// number.
double HeadingCorrection::log_likelihood(std::span<const csht::TargetTrack> tracks) {
  double sum = 0.0, count = 0.0;
  for (const csht::TargetTrack& track : tracks) {
    if (!tells(track)) continue;
    ratio_.assign(track.cloud.size(), 1.0);
    csht::multiply_by_ratio(table_, nullptr, track.cloud.span(), 0.0, {}, ratio_);
    const double mean = std::inner_product(ratio_.begin(), ratio_.end(), track.cloud.weight.begin(), 0.0);
    const double existence = track.existence();
    sum += std::log(1.0 - existence + existence * mean);
    count += existence;
  }
  return sum * std::max(0.0, count - 1.0) / count;
}

}  // namespace lookout::tracking
