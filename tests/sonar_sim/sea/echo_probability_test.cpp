#include "sonar_sim/sea/echo_probability.hpp"

#include <gtest/gtest.h>

#include "tests/support/sea_ping.hpp"

namespace lookout::sonar_sim {
namespace {

TEST(EchoProbability, GrowsWithRangeAndAspectUpToOne) {
  const EchoProbability plan{0.6, 2.0, 150.0, 0.2};
  EXPECT_DOUBLE_EQ(miss_probability(plan, 0.1, 0.0, 0.0), 0.1);
  EXPECT_DOUBLE_EQ(miss_probability(plan, 0.1, 75.0, 0.0), 0.1 + 0.6 / 4.0);
  EXPECT_DOUBLE_EQ(miss_probability(plan, 0.1, 150.0, 0.5), 0.1 + 0.6 + 0.05);
  EXPECT_DOUBLE_EQ(miss_probability(plan, 0.9, 150.0, 1.0), 1.0);
}

TEST(EchoProbability, AspectIsBetweenVelocityAndLineOfSight) {
  const Ping ping = ping_at_origin();
  core::GroundTruth truth;
  truth.targets = {{1, {100.0, 0.0}, {1.0, 0.0}, true},   // stern on
                   {2, {100.0, 0.0}, {0.0, 2.0}, true},   // from the side
                   {3, {100.0, 0.0}, {1.0, 1.0}, true},   // cos^2 of 45 degrees
                   {4, {100.0, 0.0}, {0.0, 0.0}, true}};  // no aspect
  std::vector<BeamTarget> targets{
      {45, 100.0, 0.0, 0}, {45, 100.0, 0.0, 1}, {45, 100.0, 0.0, 2}, {45, 100.0, 0.0, 3}};
  weaken({0.0, 2.0, 150.0, 0.4}, ping, truth, targets);
  EXPECT_NEAR(*targets[0].miss_probability, 0.5, 1e-12);
  EXPECT_NEAR(*targets[1].miss_probability, 0.1, 1e-12);
  EXPECT_NEAR(*targets[2].miss_probability, 0.3, 1e-12);
  EXPECT_NEAR(*targets[3].miss_probability, 0.1, 1e-12);
}

}  // namespace
}  // namespace lookout::sonar_sim
