#include "tools/experiments/harness/simulated_run.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

TEST(SimulatedRun, EveryScanHasThePoseOfItsTime) {
  const auto scene = load_variant("window_table2.yaml", {0.1, 0.5, 2.0, sonar_sim::ClutterReading::light});
  EXPECT_EQ(*scene.platforms[0].sonar.params.miss_probability, 0.5);
  EXPECT_EQ(scene.platforms[0].sonar.echo_range_sigma, 2.0);
  const auto scans = simulate(scene, 1, 0);
  ASSERT_EQ(scans.size(), 20u);
  EXPECT_NEAR(scans[10].posed.T_earth_sonar.north, -10.0 + 0.5 * 5.0, 1e-9);  // Table 2: 0.5 m/s from -10 m
  EXPECT_EQ(scans[10].truth.targets.size(), 3u);
}

// Without navigation faults the intake changes nothing; reports that come late still find their scan.
TEST(SimulatedRun, TheIntakePosesTheSameScans) {
  auto scene = load_variant("window_table2.yaml", {0.1, 0.5, 2.0, sonar_sim::ClutterReading::light});
  const auto plain = simulate(scene, 1, 0);
  for (const double delay : {0.0, 0.4}) {
    scene.platforms[0].vehicle.navigation.delay = delay;
    const auto scans = simulate_through_intake(scene, 1, 0);
    ASSERT_EQ(scans.size(), plain.size());
    for (std::size_t k = 0; k < scans.size(); ++k) {
      EXPECT_EQ(scans[k].truth.utime, plain[k].truth.utime);
      EXPECT_EQ(scans[k].posed.scan.returns.size(), plain[k].posed.scan.returns.size());
      EXPECT_NEAR(scans[k].posed.T_earth_sonar.north, plain[k].posed.T_earth_sonar.north, 1e-9);
    }
  }
}

// The course of Table 2's first target and of the vehicle: the same at the end, longer at the beginning.
TEST(SimulatedRun, ASceneBegunEarlierEndsAsItWas) {
  const auto scene = load_variant("window_table2.yaml", {0.1, 0.5, 2.0, sonar_sim::ClutterReading::literal});
  auto longer = scene;
  begin_earlier(20.0, longer);
  const auto scans = simulate(scene, 1, 0), longer_scans = simulate(longer, 1, 0);
  ASSERT_EQ(longer_scans.size(), 60u);
  for (const auto& timed : longer_scans)
    for (const auto& target : timed.truth.targets) EXPECT_TRUE(target.visible);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_TRUE(
        longer_scans.back().truth.targets[k].position.isApprox(scans.back().truth.targets[k].position));
  EXPECT_NEAR(longer_scans.back().posed.T_earth_sonar.north, scans.back().posed.T_earth_sonar.north, 1e-9);
}

TEST(SimulatedRun, OnlyStraightScenesBeginEarlier) {
  auto scene = load_variant("window_table2.yaml", {});
  scene.targets[1].turn_rate = 0.1;
  EXPECT_THROW(begin_earlier(1.0, scene), std::invalid_argument);
}

TEST(SimulatedRun, UnknownReadingIsRefused) {
  EXPECT_THROW(clutter_reading("heavy"), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tools
