#include "tracking/initiation/plots/false_chains.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

// Two plots of four scans have no residual: C(4, 2) = 6 patterns.
TEST(FalseChains, OfTwoPlotsAreThePatterns) {
  EXPECT_NEAR(log_false_chains(-1.0, 0.0, 2, 4), -1.0 + std::log(6.0), 1e-12);
}

// Four plots of five scans: 5 patterns, and a ball of four dimensions and squared radius 8: pi^2 8^2 / 2.
TEST(FalseChains, AreTheVolumeOfTheResidualsBall) {
  const double volume = std::numbers::pi * std::numbers::pi * 64.0 / 2.0;
  EXPECT_NEAR(log_false_chains(0.0, 8.0, 4, 5), std::log(5.0 * volume), 1e-12);
}

TEST(FalseChains, AFitBetterThanATrueOneTellsNoMore) {
  EXPECT_EQ(log_false_chains(0.0, 0.1, 4, 5), log_false_chains(0.0, 2.0, 4, 5));
}

// Variance 4 of the measured velocity, 1 of the prior around zero: a fifth of it remains, with variance 4
// / 5.
TEST(SpeedPrior, PullsTowardsRest) {
  TrackFit fit;
  fit.track.state << 7.0, 8.0, 5.0, -5.0;
  fit.track.covariance = Eigen::Vector4d(9.0, 9.0, 4.0, 4.0).asDiagonal();
  add_speed_prior(1.0, fit);
  EXPECT_LT((fit.track.state - Eigen::Vector4d(7.0, 8.0, 1.0, -1.0)).norm(), 1e-12);
  EXPECT_NEAR(fit.track.covariance(2, 2), 0.8, 1e-12);
  EXPECT_NEAR(fit.track.covariance(0, 0), 9.0, 1e-12);
}

// 3.5 m/s known to .2 m/s may be 3 m/s to three sigmas, known to .1 m/s not.
TEST(SpeedAllowed, WithinSomeSigmas) {
  TrackFit fit;
  fit.track.state << 0.0, 0.0, 3.5, 0.0;
  fit.track.covariance = 0.04 * Eigen::Matrix4d::Identity();
  EXPECT_TRUE(speed_allowed(fit, {0.0, 3.0}, 3.0));
  fit.track.covariance *= 0.25;
  EXPECT_FALSE(speed_allowed(fit, {0.0, 3.0}, 3.0));
}

}  // namespace
}  // namespace lookout::tracking
