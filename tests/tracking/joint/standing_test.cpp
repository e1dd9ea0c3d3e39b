#include "tracking/joint/standing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

constexpr double kSigma = 1.0, kCreep = 0.1, kShare = 0.1;

csht::CloudMoments moving_at(double north, double east, double sigma) {
  csht::CloudMoments moments;
  moments.mean.setZero();
  moments.covariance.setZero();
  moments.mean[2] = north;
  moments.mean[3] = east;
  moments.covariance(2, 2) = moments.covariance(3, 3) = sigma * sigma;
  return moments;
}

double density(double x, double sigma) {
  return std::exp(-0.5 * x * x / (sigma * sigma)) / (sigma * std::sqrt(2.0 * std::numbers::pi));
}

TEST(Standing, FollowsFromTheDensitiesAtZero) {
  const double after = std::hypot(0.2, kCreep), before = std::hypot(kSigma, kCreep);
  const double factor =
      density(0.3, after) * density(0.1, after) / (density(0.0, before) * density(0.0, before));
  const double odds = kShare / (1.0 - kShare) * factor;
  EXPECT_NEAR(moving_probability(moving_at(0.3, 0.1, 0.2), kSigma, kCreep, kShare), 1.0 / (1.0 + odds),
              1e-12);
}

// Velocity says nothing yet: the share of what stands is all that is known.
TEST(Standing, BeforeTheVelocityIsKnownTheShareHolds) {
  EXPECT_NEAR(moving_probability(moving_at(0.0, 0.0, kSigma), kSigma, kCreep, kShare), 1.0 - kShare, 1e-12);
}

TEST(Standing, SlowTargetsThatAreWellKnownMove) {
  EXPECT_GT(moving_probability(moving_at(0.4, 0.0, 0.05), kSigma, kCreep, kShare), 0.95);
  EXPECT_LT(moving_probability(moving_at(0.05, 0.0, 0.05), kSigma, kCreep, kShare), 0.2);
}

}  // namespace
}  // namespace lookout::tracking
