#include "tracking/intake/pose_guard.hpp"

#include <cmath>

namespace lookout::tracking {

PoseGuard::PoseGuard(const PoseGuardParams& params)
    : params_(params), position_(params.position), heading_(params.heading) {}

std::string_view PoseGuard::doubt(const core::VehicleState& state) {
  const core::Pose2& pose = state.T_earth_body;
  const core::Pose2 reckoned = newest_ ? reckoned_at(state) : pose;
  const double away = std::hypot(pose.north - reckoned.north, pose.east - reckoned.east);
  const bool leaps = position_.is_leap(state.utime, away);
  const bool turns =
      heading_.is_leap(state.utime, std::abs(core::wrap_to_pi(pose.heading - reckoned.heading)));
  if (!newest_ || state.utime >= newest_->utime) {
    newest_ = state;
    line_ = leaps ? reckoned : pose;
    line_.heading = turns ? reckoned.heading : pose.heading;
  }
  if (leaps) return "its position leaps against its own velocity: another unit, another origin?";
  return turns ? "its heading leaps, faster than a vehicle turns: degrees?" : std::string_view();
}

/// Where the believed line goes on to by the velocities of either state.
core::Pose2 PoseGuard::reckoned_at(const core::VehicleState& state) const {
  const Eigen::Vector2d way =
      0.5 * core::seconds(state.utime - newest_->utime) * (state.velocity + newest_->velocity);
  return {line_.north + way.x(), line_.east + way.y(), line_.heading};
}

}  // namespace lookout::tracking
