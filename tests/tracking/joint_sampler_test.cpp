#include "tracking/joint_sampler.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracking/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

constexpr int kOwners = 4;

// Twenty scans of one target on a straight line through every beam that it should be in.
JointLikelihood straight_line(const csht::SensorFigures& figures) {
  JointLikelihood likelihood(figures, {}, {}, 40, kOwners);
  for (int k = 0; k < 20; ++k) likelihood.push(scan_of(k, {{60.0 + 0.5 * k, 10.0}}));
  return likelihood;
}

SamplingTask around_truth() {
  SamplingTask task;
  task.guess.mean << 69.5, 10.0, 1.0, 0.0, 0.0, 0.0;
  task.guess.covariance.diagonal() << 4.0, 4.0, 0.25, 0.25, 0.0, 0.0;
  task.ages = {0, 19};
  task.rounds = 5;
  return task;
}

TEST(JointSampler, FindsTheTargetWithinItsOwnSpread) {
  JointLikelihood likelihood = straight_line({});
  core::Random random(1);
  JointSampler sampler({}, 3.0, random);
  JointCloud cloud;
  const SamplingResult result = sampler.sample(around_truth(), likelihood, random, cloud);
  const CloudMoments moments = cloud.moments();
  for (int k = 0; k < 4; ++k)
    EXPECT_LT(std::abs(moments.mean[k] - around_truth().guess.mean[k]),
              3.0 * std::sqrt(moments.covariance(k, k)));
  EXPECT_GT(result.effective_share, 0.2);
  EXPECT_NEAR(result.log_evidence, 71.85, 0.3);  // Of 4096 trajectories in six rounds of the same sampler.
}

// The evidence is an integral: a proposal twice as wide must not change it beyond its sampling error.
TEST(JointSampler, EvidenceDoesNotDependOnTheProposal) {
  JointLikelihood likelihood = straight_line({});
  core::Random random(2);
  JointCloudParams params;
  params.refresh_goal = 0.5;
  JointSampler sampler(params, 3.0, random);
  JointCloud cloud;
  SamplingTask narrow = around_truth(), wide = around_truth();
  narrow.samples = wide.samples = 4096;
  narrow.rounds = wide.rounds = 8;
  wide.guess.covariance *= 4.0;
  const double first = sampler.sample(narrow, likelihood, random, cloud).log_evidence;
  const double second = sampler.sample(wide, likelihood, random, cloud).log_evidence;
  EXPECT_NEAR(first, second, 0.1);
}

TEST(JointSampler, GivesUpOnAHopelessGuess) {
  JointLikelihood likelihood = straight_line({});
  core::Random random(3);
  JointSampler sampler({}, 3.0, random);
  JointCloud cloud;
  SamplingTask task = around_truth();
  task.guess.mean[1] = -40.0;
  task.give_up_below = 0.0;
  EXPECT_LT(sampler.sample(task, likelihood, random, cloud).log_evidence, 0.0);
}

// Behind the sonar the scans say nothing: what is left is the anchor's Gaussian, whose integral is 1, moved
// on for 2 s.
TEST(JointSampler, AnAnchorHoldsATrajectoryThatNobodySees) {
  JointLikelihood likelihood = straight_line({});
  core::Random random(6);
  JointSampler sampler({}, 3.0, random);
  SamplingTask task;
  task.guess.mean << -60.0, 5.0, 0.0, 0.0, 0.0, 0.0;
  task.guess.covariance.diagonal() << 9.0, 9.0, 0.25, 0.25, 0.0, 0.0;
  task.ages = {0, 4};
  task.samples = 4096;
  task.rounds = 6;
  task.anchor = Anchor{-2.0, {-60.0, 5.0, 0.0, 0.0}, Eigen::Vector4d(4.0, 4.0, 0.09, 0.09).asDiagonal()};
  JointCloud cloud;
  EXPECT_NEAR(sampler.sample(task, likelihood, random, cloud).log_evidence, 0.0, 0.1);
  const CloudMoments moments = cloud.moments();
  EXPECT_NEAR(moments.covariance(0, 0), 4.0 + 4.0 * 0.09, 0.6);
  EXPECT_NEAR(moments.covariance(0, 2), 2.0 * 0.09, 0.06);
}

TEST(JointSampler, SpeedPriorIsFlatUpToTheLimit) {
  core::Random random(4);
  const JointSampler sampler({}, 3.0, random);
  EXPECT_EQ(sampler.log_prior(2.9, 0.0, false), 0.0);
  EXPECT_LT(sampler.log_prior(4.0, 0.0, false), -10.0);
}

}  // namespace
}  // namespace lookout::tracking
