#include "csht/joint/density/target_prior.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/parameter_check.hpp"

namespace lookout::csht {
namespace {

double sector_of(const ScanTable& scan) {
  return std::min(2.0 * std::numbers::pi, scan.sector());
}

double area_of(const ScanTable& scan) {
  return 0.5 * sector_of(scan) * scan.max_range * scan.max_range;
}

}  // namespace

void validate(const TargetPriorParams& p) {
  core::require(p.expected_targets > 0.0, "expected_targets must be > 0", p.expected_targets);
  core::require(p.interior_rate >= 0.0, "interior_rate must be >= 0", p.interior_rate);
  core::require(p.settling_s >= 0.0, "settling_s must be >= 0", p.settling_s);
  core::require(p.settling_rate >= 0.0, "settling_rate must be >= 0", p.settling_rate);
  core::require(p.speed_sigmas > 0.0, "speed_sigmas must be > 0", p.speed_sigmas);
  core::require(p.speed_edge > 0.0, "speed_edge must be > 0", p.speed_edge);
}

TargetPrior::TargetPrior(const TargetPriorParams& params, double max_speed, double scan_period)
    : params_(params),
      max_speed_(max_speed),
      velocity_sigma_(max_speed / params.speed_sigmas),
      settling_((params.interior_rate + params.settling_rate) * scan_period),
      settled_(params.interior_rate * scan_period),
      log_settling_(std::log(settling_ / params.expected_targets)),
      log_settled_(std::log(settled_ / params.expected_targets)) {}

void TargetPrior::set_expected_targets(double expected) {
  params_.expected_targets = expected;
  log_settling_ = std::log(settling_ / expected);
  log_settled_ = std::log(settled_ / expected);
}

double TargetPrior::log_speed(double speed) const {
  if (params_.uniform_speeds) return log_edge(speed);
  const double square = speed / velocity_sigma_;
  return -0.5 * square * square + log_edge(speed);
}

double TargetPrior::log_edge(double speed) const {
  const double excess = std::max(0.0, speed - max_speed_) / params_.speed_edge;
  return -0.5 * excess * excess;
}

double TargetPrior::log_standing(const ScanTable& scan) const {
  const double velocities = params_.uniform_speeds
                                ? std::numbers::pi * max_speed_ * max_speed_
                                : 2.0 * std::numbers::pi * velocity_sigma_ * velocity_sigma_;
  return std::log(params_.expected_targets / (area_of(scan) * velocities));
}

double TargetPrior::appearing(double seconds_since_first) const {
  return seconds_since_first < params_.settling_s ? settling_ : settled_;
}

double TargetPrior::log_birth(double seconds_since_first) const {
  return seconds_since_first < params_.settling_s ? log_settling_ : log_settled_;
}

// The flux of points, spread evenly and moving in all directions alike, over a border: density x mean speed x
// length / pi. A speed whose two components are normal is Rayleigh distributed, with mean sigma sqrt(pi / 2).
double TargetPrior::entering(const ScanTable& scan, double seconds) const {
  const double border = scan.max_range * (sector_of(scan) + (scan.whole_circle ? 0.0 : 2.0));
  const double mean_speed = velocity_sigma_ * std::sqrt(0.5 * std::numbers::pi);
  return params_.expected_targets / area_of(scan) * mean_speed * border / std::numbers::pi * seconds;
}

}  // namespace lookout::csht
