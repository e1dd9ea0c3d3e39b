#include "csht/joint/clusters.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/csht/joint/joint_scenes.hpp"

namespace lookout::csht {
namespace {

using testing::Course;
const Course kCourse{{80, 10}, {-1, 2}};
const TrajectoryPrior kPrior({.interior_birth_rate = 0.0, .max_speed = 5.0});

TargetHypothesis start(double position_error, double velocity_error) {
  TargetHypothesis hypothesis;
  hypothesis.mean << kCourse.at(9.5), kCourse.velocity;
  hypothesis.mean += Eigen::Vector4d(position_error, 0, velocity_error, 0);
  hypothesis.covariance = Eigen::Vector4d(9, 9, 1, 1).asDiagonal();
  return hypothesis;
}

// The integral of a Gaussian peak is its height times (2 pi)^2 sqrt(det).
TEST(JointClusters, LaplaceIsTheIntegralOfAGaussian) {
  const Eigen::Matrix4d covariance = Eigen::Vector4d(4.0, 4.0, 1.0, 1.0).asDiagonal();
  const double integral = std::exp(3.0) * 4.0 * std::numbers::pi * std::numbers::pi * 4.0;
  EXPECT_NEAR(laplace_log_odds(3.0, covariance, std::log(0.01)), std::log(integral * 0.01), 1e-12);
}

TEST(JointClusters, LeastSquaresFollowsTheEchoes) {
  const auto history =
      testing::history_of(testing::noisy_scans({kCourse}, 20, 9, 1002), testing::noisy_figures());
  ClaimSet claims;
  claims.clear(history, 20);
  std::vector<TargetHypothesis> hypotheses{start(4.0, -0.5)};
  JointClusters clusters({});
  clusters.refine(history, 20, claims, kPrior, hypotheses);
  Eigen::Vector4d truth;
  truth << kCourse.at(9.5), kCourse.velocity;
  const Eigen::Vector4d error = hypotheses[0].mean - truth;
  const double square = error.dot(hypotheses[0].covariance.inverse() * error);
  EXPECT_LT(square, 18.5);  // The 99.9 % quantile of chi-square with 4 degrees.
  // Range along north by 18 of 20 echoes, regression to the newest scan: sigma sqrt(4 / 18) = 1.4 m.
  EXPECT_NEAR(std::sqrt(hypotheses[0].covariance(0, 0)), 1.4, 0.4);
  EXPECT_NEAR(hypotheses[0].support, 18.0, 3.0);
}

TEST(JointClusters, CombinesThoseThatAgreeAndDeletesTheHopeless) {
  const auto history =
      testing::history_of(testing::noisy_scans({kCourse}, 20, 9, 1003), testing::noisy_figures());
  ClaimSet claims;
  claims.clear(history, 20);
  std::vector<TargetHypothesis> hypotheses{start(1.0, 0.2), start(-1.0, -0.2), start(-50.0, 0.0)};
  JointClusters clusters({});
  clusters.refine(history, 20, claims, kPrior, hypotheses);
  clusters.combine_and_delete(hypotheses);
  ASSERT_EQ(hypotheses.size(), 1u);
  EXPECT_LT((hypotheses[0].mean.head<2>() - kCourse.at(9.5)).norm(), 6.0);
}

TEST(JointClusters, RefusesNonsense) {
  EXPECT_THROW(JointClusters({.rounds = 0}), std::invalid_argument);
  EXPECT_THROW(JointClusters({.merge_distance = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
