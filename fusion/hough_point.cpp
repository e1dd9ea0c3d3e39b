#include "fusion/hough_point.hpp"

#include <cmath>
#include <numbers>

namespace lookout::fusion {

std::optional<HoughPoint> hough_point(const Eigen::Vector2d& older, const Eigen::Vector2d& newer,
                                      const Eigen::Vector2d& origin) {
  constexpr double kStandingStill = 1e-9;  // Metres: below it the direction is rounding noise.
  const Eigen::Vector2d step = newer - older;
  const double length = step.norm();
  if (length < kStandingStill) return std::nullopt;
  const Eigen::Vector2d p = newer - origin;
  double theta = std::atan2(-step.x(), step.y());
  if (theta >= std::numbers::pi / 2) theta -= std::numbers::pi;
  if (theta < -std::numbers::pi / 2) theta += std::numbers::pi;
  return HoughPoint{std::abs(step.y() * p.x() - step.x() * p.y()) / length, theta};
}

double hough_distance(const HoughPoint& a, const HoughPoint& b, double length_unit) {
  return std::hypot((a.rho - b.rho) / length_unit, a.theta - b.theta);
}

}  // namespace lookout::fusion
