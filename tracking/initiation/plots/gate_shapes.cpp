#include "tracking/initiation/plots/gate_shapes.hpp"

#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

void SpeedLimits::validate() const {
  core::require_not_negative("min_speed", min);
  core::require(max > min, "max_speed must be > min_speed", max);
}

bool in_annulus(const Eigen::Vector2d& displacement, double seconds, const SpeedLimits& speeds,
                double margin) {
  const double length = displacement.norm();
  return length > 0.0 && length >= speeds.min * seconds - margin && length <= speeds.max * seconds + margin;
}

double angle_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

bool in_fan(const Eigen::Vector2d& reached, const Eigen::Vector2d& expected, double depth, double turn) {
  return std::abs(reached.norm() - expected.norm()) < 0.5 * depth && angle_between(reached, expected) < turn;
}

}  // namespace lookout::tracking
