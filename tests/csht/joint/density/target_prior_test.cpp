#include "csht/joint/density/target_prior.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "csht/likelihood/scan_history.hpp"
#include "tests/support/sonar_scene.hpp"

namespace lookout::csht {
namespace {

constexpr double kField = std::numbers::pi / 4.0 * 150.0 * 150.0;  // Of 90 beams of 1 degree [m^2].

ScanHistory one_scan() {
  ScanHistory scans({}, {}, 2);
  scans.push(scan_of(0, {}));
  return scans;
}

TEST(TargetPrior, SpreadsTheExpectedTargetsOverFieldAndVelocities) {
  const ScanHistory scans = one_scan();
  const TargetPrior prior({.expected_targets = 2.0, .speed_sigmas = 6.0}, 3.0);
  // The integral of exp(log_speed) over the plane of velocities, in rings of 1 mm/s.
  double velocities = 0.0;
  for (double speed = 0.0005; speed < 5.0; speed += 0.001)
    velocities += std::exp(prior.log_speed(speed)) * 2.0 * std::numbers::pi * speed * 0.001;
  EXPECT_NEAR(std::exp(prior.log_standing(scans.newest())) * kField * velocities, 2.0, 1e-3);
}

TEST(TargetPrior, VelocitiesAreNormalAndLimited) {
  const TargetPrior prior({.speed_sigmas = 3.0}, 3.0);
  EXPECT_EQ(prior.velocity_sigma(), 1.0);
  EXPECT_EQ(prior.log_speed(0.0), 0.0);
  EXPECT_NEAR(prior.log_speed(2.0), -2.0, 1e-12);
  EXPECT_EQ(prior.log_edge(2.9), 0.0);
  EXPECT_LT(prior.log_edge(4.0), -10.0);
  EXPECT_LT(prior.log_speed(4.0), prior.log_edge(4.0));
}

TEST(TargetPrior, MoreComeIntoSightWhileTheSonarSettles) {
  const TargetPrior prior(
      {.expected_targets = 2.0, .interior_rate = 0.002, .settling_s = 2.0, .settling_rate = 1.0}, 3.0, 0.5);
  EXPECT_NEAR(prior.appearing(0.0), 0.501, 1e-12);
  EXPECT_NEAR(prior.appearing(2.0), 0.001, 1e-12);
  for (const double seconds : {0.0, 1.9, 2.0, 100.0})
    EXPECT_NEAR(prior.log_birth(seconds), std::log(prior.appearing(seconds) / 2.0), 1e-12);
}

TEST(TargetPrior, AsManyAppearInAMinuteHoweverOftenTheSonarLooks) {
  const TargetPrior fast({}, 3.0, 0.25), slow({}, 3.0, 1.5);
  EXPECT_NEAR(240.0 * fast.appearing(60.0), 40.0 * slow.appearing(60.0), 1e-12);
}

TEST(TargetPrior, WhatEntersIsTheFluxOverTheBorder) {
  const ScanHistory scans = one_scan();
  // By hand: 2 targets x 1.253 m/s x 535.6 m / (pi x 17671 m^2) x 0.5 s.
  EXPECT_NEAR(TargetPrior().entering(scans.newest(), 0.5), 0.01209, 2e-5);
}

TEST(TargetPrior, RefusesValuesOutOfRange) {
  EXPECT_NO_THROW(validate(TargetPriorParams{}));
  EXPECT_THROW(validate(TargetPriorParams{.expected_targets = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(TargetPriorParams{.interior_rate = -0.1}), std::invalid_argument);
  EXPECT_THROW(validate(TargetPriorParams{.settling_s = -1.0}), std::invalid_argument);
  EXPECT_THROW(validate(TargetPriorParams{.settling_rate = -1.0}), std::invalid_argument);
  EXPECT_THROW(validate(TargetPriorParams{.speed_sigmas = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(TargetPriorParams{.speed_edge = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
