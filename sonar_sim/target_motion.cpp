#include "sonar_sim/target_motion.hpp"

#include <cmath>

namespace lookout::sonar_sim {
namespace {

/// Below this turn [rad] the closed form of the arc loses digits and the straight line is exact enough.
constexpr double kStraight = 1e-9;

}  // namespace

TargetState target_state(const TargetPlan& plan, double time) {
  const double speed = plan.velocity.norm();
  const double course = std::atan2(plan.velocity.y(), plan.velocity.x());
  const double omega = plan.turn_rate;
  const double final_speed = speed + plan.acceleration * time;
  const double final_course = course + omega * time;
  const Eigen::Vector2d heading_start(std::cos(course), std::sin(course));
  const Eigen::Vector2d heading_end(std::cos(final_course), std::sin(final_course));

  TargetState state;
  state.velocity = final_speed * heading_end;
  if (std::abs(omega * time) < kStraight) {
    state.position = plan.position + (speed + 0.5 * plan.acceleration * time) * time * heading_start;
    return state;
  }
  // The integral of (speed + a t) (cos, sin)(course + omega t) by parts; `normal` is the integral of the
  // heading.
  const Eigen::Vector2d normal_start(heading_start.y(), -heading_start.x());
  const Eigen::Vector2d normal_end(heading_end.y(), -heading_end.x());
  state.position = plan.position + (final_speed * normal_end - speed * normal_start) / omega +
                   plan.acceleration * (heading_end - heading_start) / (omega * omega);
  return state;
}

}  // namespace lookout::sonar_sim
