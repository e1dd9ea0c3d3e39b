#include "tracking/joint_prior.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace lookout::tracking {
namespace {

double sector_of(const csht::ScanTable& scan) {
  return std::min(2.0 * std::numbers::pi, scan.num_beams * scan.bearing_step);
}

double area_of(const csht::ScanTable& scan) {
  return 0.5 * sector_of(scan) * scan.max_range * scan.max_range;
}

void require(bool holds, const char* rule, double value) {
  if (!holds) throw std::invalid_argument(std::string(rule) + ", got " + std::to_string(value));
}

}  // namespace

void validate(const JointPriorParams& p) {
  require(p.expected_targets > 0.0, "expected_targets must be > 0", p.expected_targets);
  require(p.interior_rate > 0.0, "interior_rate must be > 0", p.interior_rate);
  require(p.settling_s >= 0.0, "settling_s must be >= 0", p.settling_s);
  require(p.settling_rate >= 0.0, "settling_rate must be >= 0", p.settling_rate);
  require(p.speed_sigmas > 0.0, "speed_sigmas must be > 0", p.speed_sigmas);
  require(p.speed_edge > 0.0, "speed_edge must be > 0", p.speed_edge);
}

JointPrior::JointPrior(const JointPriorParams& params, double max_speed, double scan_period)
    : params_(params),
      max_speed_(max_speed),
      velocity_sigma_(max_speed / params.speed_sigmas),
      settling_((params.interior_rate + params.settling_rate) * scan_period),
      settled_(params.interior_rate * scan_period),
      log_settling_(std::log(settling_ / params.expected_targets)),
      log_settled_(std::log(settled_ / params.expected_targets)) {}

double JointPrior::log_speed(double speed) const {
  const double square = speed / velocity_sigma_;
  return -0.5 * square * square + log_edge(speed);
}

double JointPrior::log_edge(double speed) const {
  const double excess = std::max(0.0, speed - max_speed_) / params_.speed_edge;
  return -0.5 * excess * excess;
}

double JointPrior::log_standing(const csht::ScanTable& scan) const {
  const double volume = area_of(scan) * 2.0 * std::numbers::pi * velocity_sigma_ * velocity_sigma_;
  return std::log(params_.expected_targets / volume);
}

double JointPrior::appearing(double seconds_since_first) const {
  return seconds_since_first < params_.settling_s ? settling_ : settled_;
}

double JointPrior::log_birth(double seconds_since_first) const {
  return seconds_since_first < params_.settling_s ? log_settling_ : log_settled_;
}

// The flux of uniformly moving points over a closed border: density x mean speed x length / pi; the mean
// speed of normal components is sigma sqrt(pi / 2).
double JointPrior::entering(const csht::ScanTable& scan, double seconds) const {
  const double border = scan.max_range * (sector_of(scan) + (scan.whole_circle ? 0.0 : 2.0));
  const double mean_speed = velocity_sigma_ * std::sqrt(0.5 * std::numbers::pi);
  return params_.expected_targets / area_of(scan) * mean_speed * border / std::numbers::pi * seconds;
}

}  // namespace lookout::tracking
