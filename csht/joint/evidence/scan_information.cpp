#include "csht/joint/evidence/scan_information.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lookout::csht {
namespace {

// How unsure the pose leaves the beam of a target at half the maximum range: the entropy of its beam number
// [nats], taken for that of a normal distribution, with a 1 added that makes it 0 where the pose is exact.
double entropy_of_beam(const ScanTable& scan) {
  if (scan.blur_reach == 0) return 0.0;
  const double heading = static_cast<double>(scan.blur_heading);
  const double position = static_cast<double>(scan.blur_position) / (0.5 * scan.max_range);
  const double variance = heading * heading + position * position;
  return 0.5 * std::log(1.0 + 2.0 * std::numbers::pi * std::numbers::e * variance);
}

}  // namespace

ScanEvidence evidence_of(const SensorFigures& figures, const ScanTable& scan, double background) {
  const double miss =
      figures.miss_probability + 0.5 * figures.range_loss;  // In the middle of the fan's area.
  const double detection = std::log(static_cast<double>(scan.gain) * background);
  if (scan.clutter == ClutterModel::point) return {1.0 - miss, detection - 1.0, std::log(miss)};
  // Where the pose is uncertain, a detection is the target's with the probability that it was in that beam.
  const double unsure = entropy_of_beam(scan), right = std::exp(-unsure);
  const double silence = miss * (1.0 - right + right / (1.0 - figures.false_alarm_probability));
  return {1.0 - miss, detection - 0.5 - unsure, std::log(silence)};
}

double nats_per_scan(const SensorFigures& figures, const ScanTable& scan, double background) {
  return evidence_of(figures, scan, background).mean();
}

double log_overshoot(const ScanEvidence& evidence) {
  const double detection = std::max(0.0, evidence.detection), silence = std::max(0.0, evidence.silence);
  const double step = evidence.detect * detection + (1.0 - evidence.detect) * silence;
  if (step <= 0.0) return 0.0;
  const double kept =
      -evidence.detect * std::expm1(-detection) - (1.0 - evidence.detect) * std::expm1(-silence);
  return std::log(kept / step);
}

}  // namespace lookout::csht
