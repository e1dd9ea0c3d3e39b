#include "core/frames.hpp"

#include <mrpt/math/wrap2pi.h>
#include <mrpt/poses/CPose2D.h>

#include <cmath>

namespace lookout::core {

Pose2 compose(const Pose2& T_a_b, const Pose2& T_b_c) {
  const mrpt::poses::CPose2D pose = mrpt::poses::CPose2D(T_a_b.north, T_a_b.east, T_a_b.heading) +
                                    mrpt::poses::CPose2D(T_b_c.north, T_b_c.east, T_b_c.heading);
  return {pose.x(), pose.y(), wrap_to_pi(pose.phi())};
}

Eigen::Vector2d transform(const Pose2& T_a_b, const Eigen::Vector2d& p_b) {
  const double c = std::cos(T_a_b.heading);
  const double s = std::sin(T_a_b.heading);
  return {T_a_b.north + c * p_b.x() - s * p_b.y(), T_a_b.east + s * p_b.x() + c * p_b.y()};
}

Eigen::Vector2d inverse_transform(const Pose2& T_a_b, const Eigen::Vector2d& p_a) {
  const double c = std::cos(T_a_b.heading);
  const double s = std::sin(T_a_b.heading);
  const double north = p_a.x() - T_a_b.north;
  const double east = p_a.y() - T_a_b.east;
  return {c * north + s * east, -s * north + c * east};
}

Eigen::Vector2d from_polar(double range, double bearing) {
  return {range * std::cos(bearing), range * std::sin(bearing)};
}

double wrap_to_pi(double angle) {
  return mrpt::math::wrapToPi(angle);
}

std::int64_t microseconds(double seconds) {
  return std::llround(seconds * 1e6);
}

}  // namespace lookout::core
