#include "csht/joint/density/trajectory_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lookout::csht {
namespace {

// Two trajectories of equal weight, one still at the origin, one at (2, 0) that moves north at 1 m/s.
TrajectoryCloud two_trajectories() {
  TrajectoryCloud cloud;
  cloud.resize(2);
  cloud.north[1] = 2.0;
  cloud.north_velocity[1] = 1.0;
  cloud.weight = {0.5, 0.5};
  return cloud;
}

TEST(TrajectoryCloud, MovesAlongVelocityAndAcceleration) {
  TrajectoryCloud cloud = two_trajectories();
  cloud.motion = Motion::constant_acceleration;
  cloud.north_acceleration[1] = 0.5;
  cloud.predict(2.0);
  EXPECT_DOUBLE_EQ(cloud.north[1], 2.0 + 2.0 + 1.0);
  EXPECT_DOUBLE_EQ(cloud.north_velocity[1], 2.0);
  EXPECT_DOUBLE_EQ(cloud.north[0], 0.0);
}

// A quarter of a circle in 10 s, to starboard, from north to east: radius = speed / rate.
TEST(TrajectoryCloud, MovesAlongAnArc) {
  const double rate = 0.05 * 3.14159265358979;
  TrajectoryCloud cloud = two_trajectories();
  cloud.motion = Motion::constant_turn;
  cloud.turn_rate = {0.0, rate};
  cloud.predict(10.0);
  EXPECT_NEAR(cloud.north[1], 2.0 + 1.0 / rate, 1e-9);
  EXPECT_NEAR(cloud.east[1], 1.0 / rate, 1e-9);
  EXPECT_NEAR(cloud.north_velocity[1], 0.0, 1e-9);
  EXPECT_NEAR(cloud.east_velocity[1], 1.0, 1e-9);
}

// The vectorised places are those of each trajectory on its own, however slowly it turns.
TEST(TrajectoryCloud, PlacesAllTrajectoriesWhereEachIs) {
  for (const Motion motion : {Motion::constant_turn, Motion::constant_acceleration}) {
    TrajectoryCloud cloud = two_trajectories(), at;
    cloud.motion = motion;
    cloud.turn_rate = {-0.1, 1e-9};
    cloud.east_acceleration = {0.3, -0.1};
    cloud.place(-60.0, at);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Eigen::Vector2d expected = position_at(motion, cloud.trajectory(i), -60.0);
      EXPECT_NEAR(at.north[i], expected.x(), 1e-3);
      EXPECT_NEAR(at.east[i], expected.y(), 1e-3);
    }
  }
}

// By hand: mean likelihood ratio (1 + 3) / 2; weights 1/4 and 3/4.
TEST(TrajectoryCloud, EvidenceIsTheMeanLikelihoodRatio) {
  TrajectoryCloud cloud = two_trajectories();
  const std::vector<double> log_ratio{0.0, std::log(3.0)};
  EXPECT_NEAR(cloud.reweigh(log_ratio), std::log(2.0), 1e-12);
  EXPECT_NEAR(cloud.weight[1], 0.75, 1e-12);
  EXPECT_NEAR(cloud.effective_size(), 1.0 / (0.0625 + 0.5625), 1e-12);
}

TEST(TrajectoryCloud, MomentsOfTwoPoints) {
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
}  // namespace lookout::csht
