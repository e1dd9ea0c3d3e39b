#include "tracking/joint_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lookout::tracking {
namespace {

// Two trajectories of equal weight, one still at the origin, one at (2, 0) that moves north at 1 m/s.
JointCloud two_trajectories() {
  JointCloud cloud;
  cloud.resize(2);
  cloud.north[1] = 2.0;
  cloud.north_velocity[1] = 1.0;
  cloud.weight = {0.5, 0.5};
  return cloud;
}

TEST(JointCloud, MovesAlongVelocityAndAcceleration) {
  JointCloud cloud = two_trajectories();
  cloud.north_acceleration[1] = 0.5;
  cloud.predict(2.0);
  EXPECT_DOUBLE_EQ(cloud.north[1], 2.0 + 2.0 + 1.0);
  EXPECT_DOUBLE_EQ(cloud.north_velocity[1], 2.0);
  EXPECT_DOUBLE_EQ(cloud.north[0], 0.0);
}

// By hand: mean likelihood ratio (1 + 3) / 2; weights 1/4 and 3/4.
TEST(JointCloud, EvidenceIsTheMeanLikelihoodRatio) {
  JointCloud cloud = two_trajectories();
  const std::vector<double> log_ratio{0.0, std::log(3.0)};
  EXPECT_NEAR(cloud.reweigh(log_ratio), std::log(2.0), 1e-12);
  EXPECT_NEAR(cloud.weight[1], 0.75, 1e-12);
  EXPECT_NEAR(cloud.effective_size(), 1.0 / (0.0625 + 0.5625), 1e-12);
}

TEST(JointCloud, MomentsOfTwoPoints) {
  const CloudMoments moments = two_trajectories().moments();
  EXPECT_DOUBLE_EQ(moments.mean[0], 1.0);
  EXPECT_DOUBLE_EQ(moments.covariance(0, 0), 1.0);
  EXPECT_DOUBLE_EQ(moments.covariance(2, 0), 0.5);
  EXPECT_DOUBLE_EQ(moments.covariance(0, 2), 0.5);
}

TEST(NormaliseLogWeights, StandsLargeNumbers) {
  const std::vector<double> log_weight{-2000.0, -2000.0 + std::log(3.0)};
  std::vector<double> weight(2);
  EXPECT_NEAR(normalise_log_weights(log_weight, weight), -2000.0 + std::log(4.0), 1e-9);
  EXPECT_NEAR(weight[1], 0.75, 1e-12);
}

}  // namespace
}  // namespace lookout::tracking
