#include "tracking/initiation/plots/gate_shapes.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace lookout::tracking {
namespace {

TEST(Gates, AnnulusBetweenTheSpeedLimitsWidenedByTheMargin) {
  // 2 s at 100 .. 400 m/s: 200 to 800 m, 10 m of margin.
  EXPECT_TRUE(in_annulus({195.0, 0.0}, 2.0, kFanSpeeds, 10.0));
  EXPECT_FALSE(in_annulus({185.0, 0.0}, 2.0, kFanSpeeds, 10.0));
  EXPECT_TRUE(in_annulus({0.0, -805.0}, 2.0, kFanSpeeds, 10.0));
  EXPECT_FALSE(in_annulus({0.0, -815.0}, 2.0, kFanSpeeds, 10.0));
}

TEST(Gates, ADisplacementOfZeroNeverPasses) {
  EXPECT_FALSE(in_annulus({0.0, 0.0}, 1.0, {0.0, 5.0}, 100.0));
}

TEST(Gates, AngleBetweenHasNoWrap) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(angle_between({-1.0, 0.01}, {-1.0, -0.01}), 0.02, 1e-5);
  EXPECT_DOUBLE_EQ(angle_between({1.0, 0.0}, {-1.0, 0.0}), pi);
  EXPECT_DOUBLE_EQ(angle_between({0.0, 0.0}, {1.0, 0.0}), 0.0);
}

/// [Zeng2023] section 3.2: depth 3970 m and 30 degrees.
TEST(Gates, FanBoundsLengthAndTurn) {
  const Eigen::Vector2d expected(2500.0, 0.0);
  const double turn = std::numbers::pi / 6;
  EXPECT_TRUE(in_fan({4480.0, 0.0}, expected, 3970.0, turn));
  EXPECT_FALSE(in_fan({4490.0, 0.0}, expected, 3970.0, turn));
  EXPECT_TRUE(in_fan({2000.0, 1150.0}, expected, 3970.0, turn));   // 29.9 degrees
  EXPECT_FALSE(in_fan({2000.0, 1160.0}, expected, 3970.0, turn));  // 30.1 degrees
}

TEST(Gates, RefusesLimitsThatContainNothing) {
  EXPECT_THROW((SpeedLimits{5.0, 5.0}.validate()), std::invalid_argument);
  EXPECT_THROW((SpeedLimits{-1.0, 5.0}.validate()), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
