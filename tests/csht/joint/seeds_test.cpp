#include "csht/joint/seeds.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/csht/joint/joint_scenes.hpp"

namespace lookout::csht {
namespace {

using testing::Course;
const Course kCourse{{80, 10}, {-1, 2}};

TEST(JointSeeds, OneOfTheBestFollowsTheCourse) {
  const auto history =
      testing::history_of(testing::noisy_scans({kCourse}, 20, 9, 1001), testing::noisy_figures());
  ClaimSet claims;
  claims.clear(history, 20);
  JointSeeds seeds({}, 5.0);
  const auto found = seeds.find(history, 20, claims);
  ASSERT_FALSE(found.empty());
  EXPECT_GT(seeds.last_pairs(), found.size());
  // Two echoes 9.5 s apart: sigma 3 m of the newest, 3 sqrt(2) / 9.5 m/s of the velocity; within 3 sigma.
  EXPECT_LT((found[0].state.head<2>() - kCourse.at(9.5)).norm(), 9.0);
  EXPECT_LT((found[0].state.tail<2>() - kCourse.velocity).norm(), 3.0);
  EXPECT_GE(found[0].score, found[found.size() - 1].score);
}

TEST(JointSeeds, ClaimedEchoesSeedNothing) {
  const auto history = testing::history_of(testing::scans_of({kCourse}, 20), testing::noisy_figures());
  Eigen::Vector4d state;
  state << kCourse.at(9.5), kCourse.velocity;
  ClaimSet claims;
  claims.clear(history, 20);
  claims.claim(history, std::array{state}, 1.0);
  JointSeeds seeds({}, 5.0);
  EXPECT_TRUE(seeds.find(history, 20, claims).empty());
}

TEST(JointSeeds, NoPairIsFasterThanTheLimit) {
  const Course fast{{20, 0}, {12, 0}};
  const auto history = testing::history_of(testing::scans_of({fast}, 20), testing::noisy_figures());
  ClaimSet claims;
  claims.clear(history, 20);
  JointSeeds seeds({.speed_slack = 0.0}, 5.0);
  EXPECT_TRUE(seeds.find(history, 20, claims).empty());
}

TEST(JointSeeds, CovarianceIsThatOfTwoEchoes) {
  const auto history = testing::history_of(testing::scans_of({kCourse}, 20), testing::noisy_figures());
  const Seed seed{{100.0, 0.0, 0.0, 0.0}, 10, 0.0};
  const Eigen::Matrix4d covariance = covariance_of(seed, history);
  EXPECT_NEAR(covariance(0, 0), 9.0, 1e-9);               // Along the line of sight: sigma 3 m.
  EXPECT_NEAR(covariance(2, 2), 2.0 * 9.0 / 25.0, 1e-9);  // A difference of two, over 5 s.
  EXPECT_NEAR(covariance(0, 2), 9.0 / 5.0, 1e-9);         // The newest echo is in both.
}

TEST(JointSeeds, RefusesNonsense) {
  EXPECT_THROW(JointSeeds({.min_gap = 0}, 5.0), std::invalid_argument);
  EXPECT_THROW(JointSeeds({.min_gap = 5, .max_gap = 4}, 5.0), std::invalid_argument);
  EXPECT_THROW(JointSeeds({.keep = 0}, 5.0), std::invalid_argument);
  EXPECT_THROW(JointSeeds({}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
