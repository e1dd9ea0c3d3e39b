#include "sonar_sim/vehicle_motion.hpp"

#include <gtest/gtest.h>

namespace lookout::sonar_sim {
namespace {

TEST(VehicleMotion, ConstantVelocityHeadsAlongIt) {
  VehiclePlan plan;
  plan.velocity = {0.87, 0.5};
  const auto state = VehicleMotion(plan).at(10.0);
  EXPECT_NEAR(state.T_earth_body.north, 8.7, 1e-12);
  EXPECT_NEAR(state.T_earth_body.heading, std::atan2(0.5, 0.87), 1e-12);
  EXPECT_EQ(state.utime, 10'000'000);
}

TEST(VehicleMotion, GivenHeadingIsHeld) {
  VehiclePlan plan;
  plan.velocity = {1.0, 0.0};
  plan.heading = 0.5;
  EXPECT_DOUBLE_EQ(VehicleMotion(plan).at(3.0).T_earth_body.heading, 0.5);
}

VehiclePlan dog_leg() {
  VehiclePlan plan;
  plan.turn_rate = core::radians(9.0);
  plan.waypoints = {{{10.0, 0.0}, 2.0, {}}, {{10.0, 20.0}, 1.0, {}}};
  return plan;
}

TEST(VehicleMotion, FollowsLegsAtTheirSpeeds) {
  const VehicleMotion motion(dog_leg());
  EXPECT_NEAR(motion.at(2.5).T_earth_body.north, 5.0, 1e-12);    // 2 m/s on the first leg
  EXPECT_NEAR(motion.at(15.0).T_earth_body.east, 10.0, 1e-12);   // 5 s, then 10 s at 1 m/s
  EXPECT_NEAR(motion.at(100.0).T_earth_body.east, 20.0, 1e-12);  // stopped at the last
  EXPECT_EQ(motion.at(100.0).velocity.norm(), 0.0);
}

TEST(VehicleMotion, HeadingSwingsAtTheTurnRate) {
  const VehicleMotion motion(dog_leg());
  EXPECT_NEAR(core::degrees(motion.at(4.9).T_earth_body.heading), 0.0, 1e-9);
  EXPECT_NEAR(core::degrees(motion.at(10.0).T_earth_body.heading), 45.0, 1e-9);  // 5 s at 9 deg/s
  EXPECT_NEAR(core::degrees(motion.at(20.0).T_earth_body.heading), 90.0, 1e-9);
}

TEST(VehicleMotion, ALegCanHoldItsOwnHeading) {
  VehiclePlan plan = dog_leg();
  plan.waypoints[1].heading = 0.0;
  EXPECT_NEAR(VehicleMotion(plan).at(20.0).T_earth_body.heading, 0.0, 1e-12);
}

}  // namespace
}  // namespace lookout::sonar_sim
