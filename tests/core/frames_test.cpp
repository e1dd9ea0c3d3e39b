#include "core/frames.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace lookout::core {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Frames, StarboardBearingAtHeadingEastPointsSouth) {
  // Heading east (90 deg), bearing 90 deg to starboard: the target lies south. By hand.
  const Pose2 T_earth_body{10.0, 20.0, kPi / 2};
  const Eigen::Vector2d p_earth = transform(T_earth_body, from_polar(5.0, kPi / 2));
  EXPECT_NEAR(p_earth.x(), 5.0, 1e-12);
  EXPECT_NEAR(p_earth.y(), 20.0, 1e-12);
}

TEST(Frames, ComposeEqualsTransformTwice) {
  const Pose2 T_a_b{3.0, -2.0, 0.7};
  const Pose2 T_b_c{-1.0, 4.0, 2.9};
  const Eigen::Vector2d p_c(1.5, -0.5);
  EXPECT_TRUE(transform(compose(T_a_b, T_b_c), p_c).isApprox(transform(T_a_b, transform(T_b_c, p_c)), 1e-12));
}

TEST(Frames, InverseTransformUndoesTransform) {
  const Pose2 T_a_b{3.0, -2.0, -2.4};
  const Eigen::Vector2d p_b(7.0, 1.0);
  EXPECT_TRUE(inverse_transform(T_a_b, transform(T_a_b, p_b)).isApprox(p_b, 1e-12));
}

TEST(Frames, WrapsToHalfOpenCircle) {
  EXPECT_NEAR(wrap_to_pi(3.0 * kPi / 2.0), -kPi / 2.0, 1e-12);
  EXPECT_NEAR(wrap_to_pi(-5.0 * kPi), kPi, 1e-9);
  EXPECT_DOUBLE_EQ(wrap_to_pi(0.25), 0.25);
}

TEST(Frames, MicrosecondsRoundToNearest) {
  EXPECT_EQ(microseconds(0.3), 300000);  // 0.3 * 1e6 is below 300000 in binary
  EXPECT_EQ(microseconds(-1.5e-6), -2);
  EXPECT_DOUBLE_EQ(seconds(2'500'000), 2.5);
}

}  // namespace
}  // namespace lookout::core
