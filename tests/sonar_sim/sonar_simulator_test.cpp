#include "sonar_sim/sonar_simulator.hpp"

#include <gtest/gtest.h>

namespace lookout::sonar_sim {
namespace {

const std::string kTable7 = LOOKOUT_SOURCE_DIR "/tools/scenarios/tracking_table7.yaml";

TEST(SonarSimulator, SameSeedAndRunRepeatAndOthersDiffer) {
  const Scene scene = load_scene(kTable7);
  SonarSimulator a(scene, 5, 2), b(scene, 5, 2), c(scene, 5, 3);
  const auto first = a.next()->scan.returns, same = b.next()->scan.returns, other = c.next()->scan.returns;
  ASSERT_EQ(first.size(), same.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].range, same[i].range);
  ASSERT_FALSE(other.empty());
  EXPECT_NE(first[0].range, other[0].range);
}

TEST(SonarSimulator, ScansCountFromZeroToTheEnd) {
  SonarSimulator simulator(load_scene(kTable7), 1);
  std::int64_t scans = 0;
  while (const auto simulated = simulator.next()) {
    EXPECT_EQ(simulated->scan.sequence, scans);
    EXPECT_EQ(simulated->scan.utime, 500'000 * scans);
    EXPECT_EQ(simulated->truth.utime, simulated->scan.utime);
    ++scans;
  }
  EXPECT_EQ(scans, 200);
}

TEST(SonarSimulator, InterpolatedReportsGiveTheTruePose) {
  Scene scene = load_scene(LOOKOUT_SOURCE_DIR "/tools/scenarios/turning_vehicle.yaml");
  SonarSimulator simulator(scene, 1);
  core::PoseHistory history;
  while (const auto simulated = simulator.next()) {
    for (const auto& state : simulated->states_before) history.add(state);
    for (const auto& state : simulated->states_after) history.add(state);
    const auto body = history.at(simulated->scan.utime);
    ASSERT_TRUE(body);
    const core::Pose2 sonar = core::compose(*body, simulated->scan.T_body_sonar);
    // The report pair spans a corner of the route at a waypoint, where interpolation cuts it.
    EXPECT_NEAR(sonar.north, simulated->T_earth_sonar.north, 0.08);
    EXPECT_NEAR(sonar.heading, simulated->T_earth_sonar.heading, core::radians(0.31));
  }
}

TEST(SonarSimulator, NavigationFaultsLeaveTheEchoesAlone) {
  Scene scene = load_scene(kTable7);
  SonarSimulator clean(scene, 1);
  scene.platforms[0].vehicle.navigation = {0.5, 0.02, 0.02, 0.5, 0.7};
  SonarSimulator faulty(scene, 1);
  std::size_t reports = 0;
  for (int k = 0; k < 100; ++k) {
    const auto a = clean.next(), b = faulty.next();
    ASSERT_EQ(a->scan.returns.size(), b->scan.returns.size());
    reports += b->states_before.size() + b->states_after.size();
  }
  EXPECT_NEAR(static_cast<double>(reports), 100.0, 5.0 * std::sqrt(50.0));  // half of 200 reports are lost
}

TEST(SonarSimulator, DelayedReportsArriveLater) {
  Scene scene = load_scene(kTable7);
  scene.platforms[0].vehicle.navigation.delay = 0.7;
  SonarSimulator simulator(scene, 1);
  EXPECT_TRUE(simulator.next()->states_before.empty());
  const auto second = simulator.next();  // the report of 0 s arrives at 0.7 s, after the scan at 0.5 s
  EXPECT_TRUE(second->states_before.empty());
  ASSERT_FALSE(second->states_after.empty());
  EXPECT_EQ(second->states_after[0].utime, 0);
}

}  // namespace
}  // namespace lookout::sonar_sim
