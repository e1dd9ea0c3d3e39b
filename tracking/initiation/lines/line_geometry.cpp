#include "tracking/initiation/lines/line_geometry.hpp"

#include <cmath>
#include <numbers>

namespace lookout::tracking {

Eigen::Vector2d NormalLine::normal() const {
  return {std::cos(theta), std::sin(theta)};
}

Eigen::Vector2d NormalLine::direction() const {
  return {-std::sin(theta), std::cos(theta)};
}

NormalLine canonical(const NormalLine& line) {
  constexpr double pi = std::numbers::pi;
  const double turns = std::floor(line.theta / pi);
  const bool odd = std::fmod(turns, 2.0) != 0.0;
  NormalLine folded{odd ? -line.rho : line.rho, line.theta - turns * pi};
  // Rounding can leave theta at pi itself, which is theta 0 with rho flipped.
  if (folded.theta >= pi) folded = {-folded.rho, 0.0};
  return folded;
}

std::optional<NormalLine> line_through(const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
  const Eigen::Vector2d d = q - p;
  if (d.x() == 0.0 && d.y() == 0.0) return std::nullopt;
  NormalLine line = canonical({0.0, std::atan2(d.x(), -d.y())});
  line.rho = p.dot(line.normal());
  return line;
}

NormalLine line_difference(const NormalLine& a, const NormalLine& b) {
  constexpr double pi = std::numbers::pi;
  const double apart = a.theta - b.theta;
  // Both in [0, pi), as they mostly are: half a turn either way, and no division.
  if (std::abs(apart) <= 0.5 * pi) return {a.rho - b.rho, apart};
  if (std::abs(apart) <= 1.5 * pi) return {-a.rho - b.rho, apart > 0.0 ? apart - pi : apart + pi};
  const double turns = std::round(apart / pi);
  const bool odd = std::fmod(turns, 2.0) != 0.0;
  return {(odd ? -a.rho : a.rho) - b.rho, apart - turns * pi};
}

}  // namespace lookout::tracking
