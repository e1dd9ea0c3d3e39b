#include "csht/joint/evidence/scan_information.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lookout::csht {
namespace {

// Entropy of the beam that a target was in, of one half way out [nats]: that of a normal distribution, which
// a beam's own width keeps from going below 0.
double entropy_of_beam(const ScanTable& scan) {
  if (scan.blur_reach == 0) return 0.0;
  const double heading = static_cast<double>(scan.blur_heading);
  const double position = static_cast<double>(scan.blur_position) / (0.5 * scan.max_range);
  const double variance = heading * heading + position * position;
  return 0.5 * std::log(1.0 + 2.0 * std::numbers::pi * std::numbers::e * variance);
}

}  // namespace

ScanEvidence evidence_of(const SensorFigures& figures, const ScanTable& scan) {
  const double miss = figures.miss_probability;
  const double echo = std::log(static_cast<double>(scan.gain));
  if (scan.clutter == ClutterModel::point) return {1.0 - miss, echo - 1.0, std::log(miss)};
  // Where the pose is uncertain, an echo is the target's with the probability that it was in that beam.
  const double unsure = entropy_of_beam(scan), right = std::exp(-unsure);
  const double silence = miss * (1.0 - right + right / (1.0 - figures.false_alarm_probability));
  return {1.0 - miss, echo - 0.5 - unsure, std::log(silence)};
}

double nats_per_scan(const SensorFigures& figures, const ScanTable& scan) {
  return evidence_of(figures, scan).mean();
}

double log_overshoot(const ScanEvidence& evidence) {
  const double echo = std::max(0.0, evidence.echo), silence = std::max(0.0, evidence.silence);
  const double step = evidence.detect * echo + (1.0 - evidence.detect) * silence;
  if (step <= 0.0) return 0.0;
  const double kept = -evidence.detect * std::expm1(-echo) - (1.0 - evidence.detect) * std::expm1(-silence);
  return std::log(kept / step);
}

}  // namespace lookout::csht
