#include "csht/joint/density/wander.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lookout::csht {
namespace {

constexpr double kWidest = 10.0;  // Standard deviations over the sensor's own; a return says nothing by then.

}  // namespace

Wander::Wander(const core::SonarParams& sonar)
    : rate_(sonar.point_sensor() ? sonar.wander : 0.0), scan_period_(sonar.scan_period) {}

// The integral of white noise over the time and its second integral, by their joint normal distribution.
void Wander::stray(double seconds, core::Random& random, TrajectoryCloud& cloud) const {
  if (!active() || seconds <= 0.0) return;
  const double speed = rate_ * std::sqrt(seconds), rest = speed * seconds / std::sqrt(12.0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double north = random.gaussian(speed), east = random.gaussian(speed);
    cloud.north_velocity[i] += north;
    cloud.east_velocity[i] += east;
    cloud.north[i] += 0.5 * seconds * north + random.gaussian(rest);
    cloud.east[i] += 0.5 * seconds * east + random.gaussian(rest);
  }
}

// The Kalman filter's gain on position is sqrt(2) T w with w^4 = q / (sigma^2 T), that of discounted least
// squares 2 T over the memory.
double Wander::memory(const SensorFigures& figures, double range) const {
  if (!active()) return std::numeric_limits<double>::infinity();
  const double across = range * figures.bearing_sigma;
  const double variance = 0.5 * (figures.range_sigma * figures.range_sigma + across * across);
  const double between_returns = scan_period_ / (1.0 - figures.miss_probability);
  return std::numbers::sqrt2 * std::sqrt(std::sqrt(variance * between_returns) / rate_);
}

Tolerance Wander::at_age(double age, double memory, const Tolerance& sensor) const {
  Tolerance tolerance = sensor;
  if (active()) tolerance.sigma_scale *= std::min(kWidest, std::exp(0.5 * age / memory));
  return tolerance;
}

}  // namespace lookout::csht
