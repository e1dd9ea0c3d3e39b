#include "csht/joint/density/motion_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lookout::csht {
namespace {

// East of the origin at 2 m/s to the north, turning to starboard at 0.1 rad/s: a circle of 20 m about (0,
// 25).
Trajectory on_a_circle() {
  Trajectory trajectory;
  trajectory << 0.0, 5.0, 2.0, 0.0, 0.1, 0.0;
  return trajectory;
}

TEST(JointMotion, HalfATurnLeadsToTheOtherSideOfTheCircle) {
  const Eigen::Vector4d state = state_at(Motion::constant_turn, on_a_circle(), std::numbers::pi / 0.1);
  EXPECT_LT((state - Eigen::Vector4d(0.0, 45.0, -2.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((position_at(Motion::constant_turn, on_a_circle(), -std::numbers::pi / 0.1) -
             Eigen::Vector2d(0.0, 45.0))
                .norm(),
            1e-9);
}

TEST(JointMotion, ATurnThatHardlyTurnsIsALine) {
  Trajectory slow = on_a_circle();
  slow[4] = 1e-9;
  EXPECT_LT((state_at(Motion::constant_turn, slow, 60.0) -
             state_at(Motion::constant_velocity,
                      Trajectory(slow.cwiseProduct((Trajectory() << 1, 1, 1, 1, 0, 0).finished())), 60.0))
                .norm(),
            1e-5);
}

TEST(JointMotion, ABendGathersSpeed) {
  Trajectory speeding_up = Trajectory::Zero();
  speeding_up.tail<2>() << 0.3, -0.1;
  EXPECT_LT(
      (state_at(Motion::constant_acceleration, speeding_up, 10.0) - Eigen::Vector4d(15.0, -5.0, 3.0, -1.0))
          .norm(),
      1e-9);
}

// To first order the state moves with a small change of the trajectory as the covariance says.
TEST(JointMotion, CovarianceFollowsTheTrajectories) {
  for (const Motion motion :
       {Motion::constant_velocity, Motion::constant_acceleration, Motion::constant_turn}) {
    for (int k = 0; k < dimensions(motion); ++k) {
      const Trajectory change = 1e-4 * Trajectory::Unit(k);
      const Eigen::Vector4d moved =
          state_at(motion, on_a_circle() + change, 7.0) - state_at(motion, on_a_circle(), 7.0);
      const StateMoments moments = state_moments_at(motion, on_a_circle(), change * change.transpose(), 7.0);
      EXPECT_LT((moments.covariance - moved * moved.transpose()).norm(), 1e-3 * moved.squaredNorm());
    }
  }
}

}  // namespace
}  // namespace lookout::csht
