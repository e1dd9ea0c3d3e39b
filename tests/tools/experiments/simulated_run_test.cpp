#include "tools/experiments/simulated_run.hpp"

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

TEST(SimulatedRun, UnknownReadingIsRefused) {
  EXPECT_THROW(clutter_reading("heavy"), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tools
