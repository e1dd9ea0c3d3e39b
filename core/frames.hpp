#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <numbers>

/// Frames, angles and time. Axes, signs and the zero of bearing are defined in docs/frames.md.
namespace lookout::core {

/// Pose of one plane frame in another: position [m] and heading [rad], clockwise from the parent's first
/// axis. In the earth frame the axes are north and east; in the body frame forward and starboard.
struct Pose2 {
  double north = 0.0;    ///< Position along the parent's first axis [m].
  double east = 0.0;     ///< Position along the parent's second axis [m].
  double heading = 0.0;  ///< Clockwise rotation from the parent's first axis [rad].
};

/// T_a_c from T_a_b and T_b_c; the heading comes back in (-pi, pi].
Pose2 compose(const Pose2& T_a_b, const Pose2& T_b_c);

/// Point p_b [m] of frame b in frame a. [Yan2018] Eq. (2), (3).
Eigen::Vector2d transform(const Pose2& T_a_b, const Eigen::Vector2d& p_b);

/// Point p_a [m] of frame a in frame b, the inverse of `transform`.
Eigen::Vector2d inverse_transform(const Pose2& T_a_b, const Eigen::Vector2d& p_a);

/// Range [m] and bearing [rad], positive to starboard, to a Cartesian point of the sonar frame. [Yan2018] Eq.
/// (1).
Eigen::Vector2d from_polar(double range, double bearing);

/// Angle in (-pi, pi].
double wrap_to_pi(double angle);

/// Degrees as radians.
inline constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}
/// Radians as degrees.
inline constexpr double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

/// Scenario time in microseconds as seconds, and back (rounded to the nearest microsecond).
inline constexpr double seconds(std::int64_t utime) {
  return static_cast<double>(utime) * 1e-6;
}
std::int64_t microseconds(double seconds);  ///< Seconds as microseconds, rounded to the nearest.

/// Largest |utime| that is taken from outside [us], 285 years: exact as a double, and differences cannot
/// overflow.
inline constexpr std::int64_t kMaxUtime = std::int64_t{1} << 53;

}  // namespace lookout::core
