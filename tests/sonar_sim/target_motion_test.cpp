#include "sonar_sim/target_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lookout::sonar_sim {
namespace {

TargetPlan moving(double north_velocity, double east_velocity) {
  TargetPlan plan;
  plan.position = {10.0, 20.0};
  plan.velocity = {north_velocity, east_velocity};
  return plan;
}

TEST(TargetMotion, StraightLine) {
  const TargetState state = target_state(moving(1.0, -2.0), 5.0);
  EXPECT_TRUE(state.position.isApprox(Eigen::Vector2d(15.0, 10.0)));
  EXPECT_TRUE(state.velocity.isApprox(Eigen::Vector2d(1.0, -2.0)));
}

TEST(TargetMotion, HalfACircleComesOutOneDiameterToStarboard) {
  TargetPlan plan = moving(2.0, 0.0);
  plan.turn_rate = 0.1;  // radius speed / rate = 20 m, half a circle after pi / 0.1 s
  const TargetState state = target_state(plan, std::numbers::pi / 0.1);
  EXPECT_NEAR(state.position.x(), 10.0, 1e-9);
  EXPECT_NEAR(state.position.y(), 20.0 + 40.0, 1e-9);
  EXPECT_NEAR(state.velocity.x(), -2.0, 1e-9);
}

TEST(TargetMotion, AccelerationAlongTheCourse) {
  TargetPlan plan = moving(3.0, 4.0);  // course (0.6, 0.8)
  plan.acceleration = 0.5;
  const TargetState state = target_state(plan, 2.0);  // way 5 * 2 + 0.5 * 4 / 2 = 11 m, speed 6 m/s
  EXPECT_TRUE(state.position.isApprox(Eigen::Vector2d(10.0 + 6.6, 20.0 + 8.8)));
  EXPECT_NEAR(state.velocity.norm(), 6.0, 1e-12);
}

TEST(TargetMotion, PositionIsTheIntegralOfVelocity) {
  TargetPlan plan = moving(1.0, 2.0);
  plan.turn_rate = -0.07;
  plan.acceleration = 0.03;
  const double h = 1e-5;
  for (const double t : {0.5, 7.0, 30.0}) {
    const Eigen::Vector2d slope =
        (target_state(plan, t + h).position - target_state(plan, t - h).position) / (2.0 * h);
    EXPECT_TRUE(slope.isApprox(target_state(plan, t).velocity, 1e-7));
  }
}

TEST(TargetMotion, PresentFromAppearUntilBeforeDisappear) {
  TargetPlan plan;
  plan.appear = 1.0;
  plan.disappear = 2.0;
  EXPECT_FALSE(plan.present(0.999));
  EXPECT_TRUE(plan.present(1.0));
  EXPECT_FALSE(plan.present(2.0));
}

}  // namespace
}  // namespace lookout::sonar_sim
