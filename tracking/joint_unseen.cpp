#include "tracking/joint_unseen.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

// Entropy of the beam that a target was in, of one half way out [nats]: that of a normal distribution, which
// a beam's own width keeps from going below 0.
double entropy_of_beam(const csht::ScanTable& scan) {
  if (scan.blur_reach == 0) return 0.0;
  const double heading = static_cast<double>(scan.blur_heading);
  const double position = static_cast<double>(scan.blur_position) / (0.5 * scan.max_range);
  const double variance = heading * heading + position * position;
  return 0.5 * std::log(1.0 + 2.0 * std::numbers::pi * std::numbers::e * variance);
}

}  // namespace

double nats_per_scan(const csht::SensorFigures& figures, const csht::ScanTable& scan) {
  const double detect = 1.0 - figures.miss_probability;
  const double echo = std::log(static_cast<double>(scan.gain));
  if (scan.clutter == csht::ClutterModel::point)
    return detect * (echo - 1.0) + figures.miss_probability * std::log(figures.miss_probability);
  // Where the pose is uncertain, an echo is the target's with the probability that it was in that beam.
  const double unsure = entropy_of_beam(scan), right = std::exp(-unsure);
  const double silence =
      figures.miss_probability * (1.0 - right + right / (1.0 - figures.false_alarm_probability));
  return detect * (echo - 0.5 - unsure) + figures.miss_probability * std::log(silence);
}

double JointUnseen::update(const csht::ScanTable& scan, const csht::SensorFigures& figures, double seconds) {
  const double found =
      std::clamp(nats_per_scan(figures, scan), params_.least_nats, params_.begin_nats) / params_.begin_nats;
  since_first_ += seconds;
  mean_ += prior_.entering(scan, seconds) + prior_.appearing(since_first_) - found * mean_;
  return mean_;
}

}  // namespace lookout::tracking
