#include "sonar_sim/sea/pose_errors.hpp"

#include <gtest/gtest.h>

#include "tests/support/sea_ping.hpp"

namespace lookout::sonar_sim {
namespace {

/// Variance of the heading error after `time`, over many walks of `steps` reports.
double heading_variance(double time, int steps) {
  double squares = 0.0;
  for (int k = 0; k < kPings; ++k) {
    PoseErrors errors({0.0, 0.0, 0.02, 0.0}, core::Random(static_cast<std::uint64_t>(k)));
    core::Pose2 error;
    for (int i = 1; i <= steps; ++i) error = errors.at(time * i / steps);
    squares += error.heading * error.heading;
  }
  return squares / kPings;
}

TEST(PoseErrors, TheWalkIsThatOfTheTimeWhateverThePeriod) {
  // .02 rad after a second: variance .0004 t.
  EXPECT_NEAR(heading_variance(9.0, 1), 0.0036, variance_tolerance(0.06, kPings));
  EXPECT_NEAR(heading_variance(9.0, 7), 0.0036, variance_tolerance(0.06, kPings));
}

TEST(PoseErrors, BiasAndDriftAreExact) {
  PoseErrors errors({0.05, 0.001, 0.0, 0.0}, core::Random(1));
  EXPECT_DOUBLE_EQ(errors.at(0.0).heading, 0.05);
  EXPECT_DOUBLE_EQ(errors.at(20.0).heading, 0.07);
  EXPECT_EQ(errors.at(20.0).north, 0.0);
}

TEST(PoseErrors, ThePositionWalksInBothDirections) {
  double north = 0.0, east = 0.0, product = 0.0;
  for (int k = 0; k < kPings; ++k) {
    PoseErrors errors({0.0, 0.0, 0.0, 0.5}, core::Random(static_cast<std::uint64_t>(k)));
    const core::Pose2 error = errors.at(4.0);
    north += error.north * error.north;
    east += error.east * error.east;
    product += error.north * error.east;
  }
  EXPECT_NEAR(north / kPings, 1.0, variance_tolerance(1.0, kPings));  // .25 x 4 s
  EXPECT_NEAR(east / kPings, 1.0, variance_tolerance(1.0, kPings));
  EXPECT_NEAR(product / kPings, 0.0, mean_tolerance(1.0, kPings));
}

}  // namespace
}  // namespace lookout::sonar_sim
