#include "sonar_sim/vehicle_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lookout::sonar_sim {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

double course_of(const Eigen::Vector2d& velocity, double fallback) {
  return velocity.norm() > 0.0 ? std::atan2(velocity.y(), velocity.x()) : fallback;
}

}  // namespace

VehicleMotion::VehicleMotion(const VehiclePlan& plan)
    : turn_rate_(plan.turn_rate), yaw_swing_(plan.yaw_swing), yaw_period_(plan.yaw_period) {
  if (plan.waypoints.empty()) {
    const double heading = plan.heading.value_or(course_of(plan.velocity, 0.0));
    legs_.push_back({0.0, kForever, plan.position, plan.velocity, heading, heading});
    return;
  }
  Eigen::Vector2d position = plan.position;
  double time = 0.0;
  for (const auto& waypoint : plan.waypoints) {
    const Eigen::Vector2d way = waypoint.position - position;
    const double duration = way.norm() / waypoint.speed;
    if (duration <= 0.0) continue;
    const Eigen::Vector2d velocity = way / duration;
    const double goal = waypoint.heading.value_or(plan.heading.value_or(course_of(velocity, 0.0)));
    add_leg({time, time + duration, position, velocity, goal, goal});
    time += duration;
    position = waypoint.position;
  }
  const double goal = legs_.empty() ? plan.heading.value_or(0.0) : legs_.back().heading_goal;
  add_leg({time, kForever, position, {0.0, 0.0}, goal, goal});
}

void VehicleMotion::add_leg(const Leg& leg) {
  legs_.push_back(leg);
  if (legs_.size() < 2) return;
  const Leg& before = legs_[legs_.size() - 2];
  legs_.back().heading_start = heading_on(before, before.end);
}

double VehicleMotion::heading_on(const Leg& leg, double time) const {
  const double turn = core::wrap_to_pi(leg.heading_goal - leg.heading_start);
  const double reach = turn_rate_ * (time - leg.start);
  return core::wrap_to_pi(leg.heading_start + std::clamp(turn, -reach, reach));
}

core::VehicleState VehicleMotion::at(double time) const {
  const auto next = std::upper_bound(legs_.begin() + 1, legs_.end(), time,
                                     [](double t, const Leg& leg) { return t < leg.start; });
  const Leg& leg = *(next - 1);
  const Eigen::Vector2d position = leg.position + leg.velocity * (time - leg.start);
  const double yaw = yaw_swing_ * std::sin(2.0 * std::numbers::pi * time / yaw_period_);
  const double heading = core::wrap_to_pi(heading_on(leg, time) + yaw);
  return {core::microseconds(time), {position.x(), position.y(), heading}, leg.velocity};
}

}  // namespace lookout::sonar_sim
