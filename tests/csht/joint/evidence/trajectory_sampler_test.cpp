#include "csht/joint/evidence/trajectory_sampler.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

constexpr int kOwners = 4;

// Twenty scans of one target at constant velocity, through every beam that it should be in.
ScanLikelihood straight_line(const SensorFigures& figures) {
  ScanLikelihood likelihood(figures, {}, {}, 40, kOwners);
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

TEST(TrajectorySampler, FindsTheTargetWithinItsOwnSpread) {
  ScanLikelihood likelihood = straight_line({});
  core::Random random(1);
  TrajectorySampler sampler({}, TargetPrior(), random);
  TrajectoryCloud cloud;
  const SamplingResult result = sampler.sample(around_truth(), likelihood, random, cloud);
  const CloudMoments moments = cloud.moments();
  for (int k = 0; k < 4; ++k)
    EXPECT_LT(std::abs(moments.mean[k] - around_truth().guess.mean[k]),
              3.0 * std::sqrt(moments.covariance(k, k)));
  EXPECT_GT(result.effective_share, 0.2);
  // 71.85 of 4096 trajectories in six rounds of the same sampler under a flat prior; the target moves at 1
  // m/s.
  EXPECT_NEAR(result.log_evidence, 71.85 + TargetPrior().log_speed(1.0), 0.3);
}

// The evidence is an integral: a proposal twice as wide must not change it beyond its sampling error.
TEST(TrajectorySampler, EvidenceDoesNotDependOnTheProposal) {
  ScanLikelihood likelihood = straight_line({});
  core::Random random(2);
  TrajectoryCloudParams params;
  params.refresh_goal = 0.5;
  TrajectorySampler sampler(params, TargetPrior(), random);
  TrajectoryCloud cloud;
  SamplingTask narrow = around_truth(), wide = around_truth();
  narrow.samples = wide.samples = 4096;
  narrow.rounds = wide.rounds = 8;
  wide.guess.covariance *= 4.0;
  const double first = sampler.sample(narrow, likelihood, random, cloud).log_evidence;
  const double second = sampler.sample(wide, likelihood, random, cloud).log_evidence;
  EXPECT_NEAR(first, second, 0.1);
}

TEST(TrajectorySampler, GivesUpOnAHopelessGuess) {
  ScanLikelihood likelihood = straight_line({});
  core::Random random(3);
  TrajectorySampler sampler({}, TargetPrior(), random);
  TrajectoryCloud cloud;
  SamplingTask task = around_truth();
  task.guess.mean[1] = -40.0;
  task.give_up_below = 0.0;
  EXPECT_LT(sampler.sample(task, likelihood, random, cloud).log_evidence, 0.0);
}

// Behind the sonar the scans say nothing: what is left is the anchor's Gaussian, whose integral is 1, moved
// on for 2 s.
TEST(TrajectorySampler, AnAnchorHoldsATrajectoryThatNobodySees) {
  ScanLikelihood likelihood = straight_line({});
  core::Random random(6);
  TrajectorySampler sampler({}, TargetPrior(), random);
  SamplingTask task;
  task.guess.mean << -60.0, 5.0, 0.0, 0.0, 0.0, 0.0;
  task.guess.covariance.diagonal() << 9.0, 9.0, 0.25, 0.25, 0.0, 0.0;
  task.ages = {0, 4};
  task.samples = 4096;
  task.rounds = 6;
  task.anchor = Anchor{-2.0, {-60.0, 5.0, 0.0, 0.0}, Eigen::Vector4d(4.0, 4.0, 0.09, 0.09).asDiagonal()};
  TrajectoryCloud cloud;
  EXPECT_NEAR(sampler.sample(task, likelihood, random, cloud).log_evidence, 0.0, 0.1);
  const CloudMoments moments = cloud.moments();
  EXPECT_NEAR(moments.covariance(0, 0), 4.0 + 4.0 * 0.09, 0.6);
  EXPECT_NEAR(moments.covariance(0, 2), 2.0 * 0.09, 0.06);
}

TEST(TrajectorySampler, WhereATargetWasSaysItsSpeedBetterThanThePrior) {
  core::Random random(4);
  const TrajectorySampler sampler({}, TargetPrior(), random);
  const Trajectory fast = Trajectory::Unit(2) * 2.9;
  EXPECT_EQ(sampler.log_prior(Motion::constant_velocity, fast, false), TargetPrior().log_speed(2.9));
  EXPECT_EQ(sampler.log_prior(Motion::constant_velocity, fast, true), 0.0);
  EXPECT_LT(sampler.log_prior(Motion::constant_velocity, Trajectory::Unit(2) * 4.0, true), -10.0);
}

// ln of the standard normal densities at 0 (one turn rate, two accelerations) and one sigma off.
TEST(TrajectorySampler, TurnRatesAndAccelerationsHaveAGaussianPrior) {
  core::Random random(4);
  TrajectoryCloudParams params;
  params.turn_prior = 0.1;
  params.acceleration_prior = 0.2;
  const TrajectorySampler sampler(params, TargetPrior(), random);
  const double at_zero = -0.5 * std::log(2.0 * 3.14159265358979);
  EXPECT_NEAR(sampler.log_prior(Motion::constant_turn, Trajectory::Zero(), false), at_zero - std::log(0.1),
              1e-9);
  EXPECT_NEAR(sampler.log_prior(Motion::constant_acceleration, Trajectory::Zero(), false),
              2.0 * (at_zero - std::log(0.2)), 1e-9);
  EXPECT_NEAR(sampler.log_prior(Motion::constant_turn, Trajectory::Unit(4) * 0.1, false),
              at_zero - std::log(0.1) - 0.5, 1e-9);
}

// Twenty scans of a target that runs through a full circle of 20 m radius: the rate comes out.
TEST(TrajectorySampler, FindsATurn) {
  const double rate = 2.0 * 3.14159265358979 / 9.5;
  ScanLikelihood likelihood({}, {}, {}, 40, kOwners);
  for (int k = 0; k < 20; ++k) {
    const double course = rate * (0.5 * k - 9.5);
    likelihood.push(scan_of(k, {{60.0 + std::sin(course) / rate, 10.0 + (1.0 - std::cos(course)) / rate}}));
  }
  core::Random random(5);
  TrajectoryCloudParams params;
  params.turn_prior = rate;
  TrajectorySampler sampler(params, TargetPrior(), random);
  SamplingTask task = around_truth();
  task.guess.motion = Motion::constant_turn;
  task.guess.mean << 60.0, 10.0, 1.0, 0.0, 0.8 * rate, 0.0;
  task.guess.covariance.diagonal() << 4.0, 4.0, 0.25, 0.25, 0.01, 0.0;
  TrajectoryCloud cloud;
  sampler.sample(task, likelihood, random, cloud);
  const CloudMoments moments = cloud.moments();
  EXPECT_EQ(moments.motion, Motion::constant_turn);
  EXPECT_LT(std::sqrt(moments.covariance(4, 4)), 0.1 * rate);
  EXPECT_LT(std::abs(moments.mean[4] - rate), 3.0 * std::sqrt(moments.covariance(4, 4)));
}

}  // namespace
}  // namespace lookout::csht
