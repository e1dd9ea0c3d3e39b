#include "tracking/joint_prior.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "csht/scan_history.hpp"
#include "tests/tracking/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

constexpr double kField = std::numbers::pi / 4.0 * 150.0 * 150.0;  // Of 90 beams of 1 degree [m^2].

csht::ScanHistory one_scan() {
  csht::ScanHistory scans({}, {}, 2);
  scans.push(scan_of(0, {}));
  return scans;
}

TEST(JointPrior, SpreadsTheExpectedTargetsOverFieldAndVelocities) {
  const csht::ScanHistory scans = one_scan();
  const JointPrior prior({.expected_targets = 2.0, .speed_sigmas = 6.0}, 3.0);
  // The integral of exp(log_speed) over the plane of velocities, in rings of 1 mm/s.
  double velocities = 0.0;
  for (double speed = 0.0005; speed < 5.0; speed += 0.001)
    velocities += std::exp(prior.log_speed(speed)) * 2.0 * std::numbers::pi * speed * 0.001;
  EXPECT_NEAR(std::exp(prior.log_standing(scans.newest())) * kField * velocities, 2.0, 1e-3);
}

TEST(JointPrior, VelocitiesAreNormalAndLimited) {
  const JointPrior prior({.speed_sigmas = 3.0}, 3.0);
  EXPECT_EQ(prior.velocity_sigma(), 1.0);
  EXPECT_EQ(prior.log_speed(0.0), 0.0);
  EXPECT_NEAR(prior.log_speed(2.0), -2.0, 1e-12);
  EXPECT_EQ(prior.log_edge(2.9), 0.0);
  EXPECT_LT(prior.log_edge(4.0), -10.0);
  EXPECT_LT(prior.log_speed(4.0), prior.log_edge(4.0));
}

TEST(JointPrior, MoreComeIntoSightWhileTheSonarSettles) {
  const JointPrior prior(
      {.expected_targets = 2.0, .interior_rate = 0.002, .settling_s = 2.0, .settling_rate = 1.0}, 3.0, 0.5);
  EXPECT_NEAR(prior.appearing(0.0), 0.501, 1e-12);
  EXPECT_NEAR(prior.appearing(2.0), 0.001, 1e-12);
  for (const double seconds : {0.0, 1.9, 2.0, 100.0})
    EXPECT_NEAR(prior.log_birth(seconds), std::log(prior.appearing(seconds) / 2.0), 1e-12);
}

TEST(JointPrior, AsManyAppearInAMinuteHoweverOftenTheSonarLooks) {
  const JointPrior fast({}, 3.0, 0.25), slow({}, 3.0, 1.5);
  EXPECT_NEAR(240.0 * fast.appearing(60.0), 40.0 * slow.appearing(60.0), 1e-12);
}

TEST(JointPrior, WhatEntersIsTheFluxOverTheBorder) {
  const csht::ScanHistory scans = one_scan();
  // By hand: 2 targets x 1.253 m/s x 535.6 m / (pi x 17671 m^2) x 0.5 s.
  EXPECT_NEAR(JointPrior().entering(scans.newest(), 0.5), 0.01209, 2e-5);
}

TEST(JointPrior, RefusesValuesOutOfRange) {
  EXPECT_NO_THROW(validate(JointPriorParams{}));
  EXPECT_THROW(validate(JointPriorParams{.expected_targets = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(JointPriorParams{.interior_rate = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(JointPriorParams{.settling_s = -1.0}), std::invalid_argument);
  EXPECT_THROW(validate(JointPriorParams{.settling_rate = -1.0}), std::invalid_argument);
  EXPECT_THROW(validate(JointPriorParams{.speed_sigmas = 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(JointPriorParams{.speed_edge = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
