#include "csht/joint/evidence/scan_likelihood.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

TrajectoryCloud one_at(double north, double east) {
  TrajectoryCloud cloud;
  cloud.resize(1);
  cloud.north[0] = north;
  cloud.east[0] = east;
  cloud.weight[0] = 1.0;
  return cloud;
}

double log_ratio(ScanLikelihood& likelihood, const TrajectoryCloud& cloud, const AgeSpan& ages, int self) {
  std::vector<double> sum(1, 0.0);
  likelihood.add(cloud, cloud.moments().mean, ages, self, sum);
  return sum[0];
}

// Two scans, each with one detection at 60 m dead ahead, just to starboard of the axis.
ScanLikelihood two_scans() {
  ScanLikelihood likelihood({}, {}, {}, 10, 4);
  for (int k = 0; k < 2; ++k) likelihood.push(scan_of(k, {{60.0, 0.5}}));
  return likelihood;
}

TEST(ScanLikelihood, AddsScans) {
  ScanLikelihood likelihood = two_scans();
  const TrajectoryCloud cloud = one_at(60.0, 0.5);
  const double one = log_ratio(likelihood, cloud, {0, 0}, ScanLikelihood::kNobody);
  EXPECT_GT(one, 3.0);
  EXPECT_NEAR(log_ratio(likelihood, cloud, {0, 1}, ScanLikelihood::kNobody), 2.0 * one, 1e-5);
}

TEST(ScanLikelihood, BehindANearerTargetNothingIsLearnt) {
  ScanLikelihood likelihood = two_scans();
  likelihood.set_existence(0, 1.0);
  likelihood.add_claim(0, {0, 45, 60.0F, 1.0F});
  const TrajectoryCloud farther = one_at(90.0, 0.7);
  EXPECT_NEAR(log_ratio(likelihood, farther, {0, 0}, 1), 0.0, 1e-5);
  EXPECT_LT(log_ratio(likelihood, farther, {0, 0}, 0), -5.0);  // The owner itself is not masked.
}

TEST(ScanLikelihood, AClaimCountsAsMuchAsItsOwnerExists) {
  ScanLikelihood likelihood = two_scans();
  likelihood.add_claim(0, {0, 45, 60.0F, 1.0F});
  likelihood.set_existence(0, 0.7);
  EXPECT_NEAR(likelihood.explained(0, 45, 61.0), 0.7, 1e-6);
  EXPECT_EQ(likelihood.explained(0, 45, 80.0), 0.0);
  EXPECT_NEAR(likelihood.explained(0, 46, 61.0), 0.7, 1e-6);  // Neighbouring beams too.
  EXPECT_EQ(likelihood.explained(0, 47, 61.0), 0.0);
  likelihood.set_existence(0, 0.05);
  EXPECT_EQ(likelihood.mask(0, 1, 45), nullptr);
}

TEST(ScanLikelihood, ForgetsClaims) {
  ScanLikelihood likelihood = two_scans();
  likelihood.set_existence(2, 1.0);
  likelihood.add_claim(0, {2, 45, 60.0F, 1.0F});
  likelihood.add_claim(1, {2, 45, 60.0F, 1.0F});
  likelihood.forget_claims(2, 0);
  EXPECT_EQ(likelihood.mask(0, 1, 45), nullptr);
  EXPECT_NE(likelihood.mask(1, 1, 45), nullptr);
  likelihood.forget_claims(2);
  EXPECT_EQ(likelihood.mask(1, 1, 45), nullptr);
}

// A sensor without beams, 1 degree and 3 m: 4 m behind a claimed detection it may be one's own, 10 m behind
// or 8 degrees beside it (more than 2.5 sigma) not.
TEST(ScanLikelihood, AClaimedPointIsContestedNearItAlone) {
  core::SonarParams sonar;
  sonar.clutter_per_scan = 1.0;
  sonar.bearing_sigma = core::radians(1.0);
  ScanLikelihood likelihood(figures_of(sonar), {.clutter = ClutterModel::point}, {}, 10, 4);
  likelihood.push(scan_of(0, {{60.0, 0.0}}));
  likelihood.add_claim(0, {1, 0, 60.0F, 1.0F});
  const auto at = [](double north, double east) { return one_at(north, east).moments().mean; };
  EXPECT_FALSE(likelihood.contested(0, at(64.0, 0.0)));  // The owner is not sure to exist yet.
  likelihood.set_existence(1, 1.0);
  EXPECT_TRUE(likelihood.contested(0, at(64.0, 0.0)));
  EXPECT_FALSE(likelihood.contested(0, at(70.0, 0.0)));
  EXPECT_FALSE(likelihood.contested(0, at(60.0, 8.4)));
  EXPECT_FALSE(likelihood.contested(1, at(60.0, 0.0)));  // Its own claim.
}

TEST(ScanLikelihood, ABeamIsContestedByClaimsNearby) {
  ScanLikelihood likelihood = two_scans();
  EXPECT_FALSE(likelihood.contested(0, one_at(90.0, 0.5).moments().mean));
  likelihood.add_claim(0, {1, 45, 60.0F, 1.0F});
  likelihood.set_existence(1, 1.0);
  EXPECT_TRUE(likelihood.contested(0, one_at(90.0, 0.5).moments().mean));
}

TEST(ScanLikelihood, ACurvedTrajectoryIsScoredWhereItWas) {
  ScanLikelihood likelihood = two_scans();
  TrajectoryCloud cloud = one_at(60.0, 0.5);
  cloud.motion = Motion::constant_acceleration;
  cloud.east_acceleration[0] = 400.0;  // 50 m off half a second ago.
  EXPECT_LT(log_ratio(likelihood, cloud, {1, 1}, 0), 0.0);
  EXPECT_GT(log_ratio(likelihood, cloud, {0, 0}, 0), 3.0);
}

TEST(ScanLikelihood, WhatStoodInViewBeforeWasFoundButForTheUnseen) {
  ScanLikelihood likelihood({}, {}, {}, 10, 4);
  for (int k = 0; k < 3; ++k) likelihood.push(scan_of(k, {}), 0.1);
  const auto begun = [&](double north, double east) {
    const TrajectoryCloud cloud = one_at(north, east);
    std::vector<double> sum(1, 7.0);  // What it held before is lost.
    likelihood.begin(cloud.span(), likelihood.scans().seconds_at_age(2), 2, sum);
    return sum[0];
  };
  EXPECT_NEAR(begun(60.0, 0.5), std::log(0.1), 1e-12);
  EXPECT_EQ(begun(151.0, 0.0), 0.0);  // Beyond the range.
  EXPECT_EQ(begun(10.0, 60.0), 0.0);  // Out of the sector.
  EXPECT_EQ(begun(-60.0, 0.0), 0.0);
}

TEST(ScanLikelihood, BirthsComeWithTheScansOfTheSettling) {
  const TargetPrior prior({.settling_s = 1.0});
  ScanLikelihood likelihood({}, {}, {}, 10, 4, prior);
  for (int k = 4; k < 8; ++k) likelihood.push(scan_of(k, {}));  // The first at 2 s.
  EXPECT_EQ(likelihood.log_birth(3), prior.log_birth(0.0));
  EXPECT_EQ(likelihood.log_birth(2), prior.log_birth(0.5));
  EXPECT_EQ(likelihood.log_birth(1), prior.log_birth(1.0));
  EXPECT_LT(likelihood.log_birth(1), likelihood.log_birth(2));
}

}  // namespace
}  // namespace lookout::csht
