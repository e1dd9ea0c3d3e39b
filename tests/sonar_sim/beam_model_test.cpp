#include "sonar_sim/beam_model.hpp"

#include <gtest/gtest.h>

namespace lookout::sonar_sim {
namespace {

core::GroundTruth truth_of(std::initializer_list<Eigen::Vector2d> positions) {
  core::GroundTruth truth;
  for (const auto& position : positions) truth.targets.push_back({0, position, {0, 0}, true});
  return truth;
}

TEST(BeamModel, NearerTargetOwnsASharedBeam) {
  // Both a little to starboard of dead ahead: beam 45 covers 0 to 1 degree.
  const auto visible = visible_targets(Ping{}, truth_of({{80.0, 0.5}, {40.0, 0.3}}));
  EXPECT_EQ(visible.size(), 2u);
  const auto owners = beam_owners(visible);
  ASSERT_EQ(owners.size(), 1u);
  EXPECT_EQ(owners[0].beam, 45);
  EXPECT_NEAR(owners[0].range, 40.0, 0.01);
}

TEST(BeamModel, SeveralReturnsABeamHaveSeveralOwners) {
  const auto visible = visible_targets(Ping{}, truth_of({{80.0, 0.5}, {40.0, 0.3}, {60.0, 0.4}}));
  const auto owners = beam_owners(visible, 2);
  ASSERT_EQ(owners.size(), 2u);
  EXPECT_EQ(owners[0].target, 1u);  // at 40 m
  EXPECT_EQ(owners[1].target, 2u);  // at 60 m
}

TEST(BeamModel, OutOfSectorOrRangeIsNotThere) {
  EXPECT_TRUE(visible_targets(Ping{}, truth_of({{-20.0, 0.0}, {10.0, 11.0}, {151.0, 0.0}})).empty());
}

TEST(BeamModel, FollowsThePoseOfTheSonar) {
  Ping ping;
  ping.T_earth_sonar = {0.0, 0.0, core::radians(180.0)};
  const auto visible = visible_targets(ping, truth_of({{-20.0, 0.1}}));
  ASSERT_EQ(visible.size(), 1u);
  EXPECT_EQ(visible[0].beam, 44);  // east of the axis is to port when looking south
}

}  // namespace
}  // namespace lookout::sonar_sim
