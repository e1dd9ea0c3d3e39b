#include "core/constant_velocity.hpp"

#include <gtest/gtest.h>

namespace lookout::core {
namespace {

const Eigen::Vector4d kState{1.0, 2.0, 3.0, -4.0};

TEST(ConstantVelocity, TransitionAndMovedAgree) {
  EXPECT_TRUE((constant_velocity_transition(0.5) * kState).isApprox(Eigen::Vector4d(2.5, 0.0, 3.0, -4.0)));
  EXPECT_EQ(moved(kState, 0.5), Eigen::Vector4d(2.5, 0.0, 3.0, -4.0));
}

TEST(ConstantVelocity, BackUndoesForth) {
  EXPECT_TRUE((constant_velocity_transition(-2.0) * constant_velocity_transition(2.0)).isIdentity());
}

// The integral of a process without memory: two steps of 1 s, the first carried over the second, make one of
// 2 s.
TEST(ConstantVelocity, WhiteAccelerationAddsUp) {
  const Eigen::Matrix4d F = constant_velocity_transition(1.0), Q = white_acceleration_noise(1.0, 0.3);
  EXPECT_TRUE((F * Q * F.transpose() + Q).isApprox(white_acceleration_noise(2.0, 0.3)));
}

// An acceleration a over t moves by a t^2 / 2 and speeds up by a t; with sigma 2 and t = 3: variances 81
// and 36.
TEST(ConstantVelocity, StepwiseAccelerationIsThatOfOneAcceleration) {
  const Eigen::Matrix4d Q = stepwise_acceleration_noise(3.0, 2.0);
  EXPECT_DOUBLE_EQ(Q(0, 0), 81.0);
  EXPECT_DOUBLE_EQ(Q(3, 3), 36.0);
  EXPECT_DOUBLE_EQ(Q(1, 3), 54.0);
  EXPECT_EQ(Q(0, 1), 0.0);
}

}  // namespace
}  // namespace lookout::core
