#include "tracking/baselines/gaussian/rival_scene.hpp"

#include <gtest/gtest.h>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

TEST(RivalScene, TellsTheTimeBetweenScans) {
  RivalScene scene({}, {}, {});
  scene.look(scan_of(4, {}));
  EXPECT_DOUBLE_EQ(scene.seconds(), 0.0);
  scene.finish({});
  scene.look(scan_of(7, {}));
  EXPECT_DOUBLE_EQ(scene.seconds(), 1.5);
  EXPECT_EQ(scene.utime(), 3'500'000);
}

TEST(RivalScene, BirthsAreWeighedAgainstClutter) {
  core::SonarParams sonar;
  sonar.miss_probability = 0.4;
  sonar.false_alarm_probability = 0.2;
  PopulationParams population{
      .expected_targets = 3.0, .stay = 1e9, .settling_scans = 1.0, .settling_share = 1.0};
  RivalScene scene({}, population, sonar);
  scene.look(scan_of(0, {{60.0, 0.0}}));
  const double area = 0.5 * core::radians(90.0) * 150.0 * 150.0;
  const double clutter = 0.2 / (150.0 * core::radians(1.0) * 60.0);
  EXPECT_NEAR(scene.birth_ratio(scene.view().returns()[0]), 3.0 / area * 0.6 / clutter, 1e-9);
  const double ratio = scene.birth_ratio(scene.view().returns()[0]);
  EXPECT_DOUBLE_EQ(scene.birth_existence(scene.view().returns()[0], 0.5), 0.5 * ratio / (1.0 + ratio));
  scene.finish({});
  scene.look(scan_of(1, {{60.0, 0.0}}));
  EXPECT_NEAR(scene.birth_ratio(scene.view().returns()[0]), 0.4 * 3.0 / area * 0.6 / clutter, 1e-9);
}

TEST(RivalScene, UnknownFiguresAreLearnt) {
  RivalScene scene({}, {}, {});
  for (int k = 0; k < 100; ++k) {
    scene.look(scan_of(k, {}));
    scene.finish({0.0, 90.0, 1.0, 0.9});
  }
  EXPECT_NEAR(scene.view().detection_probability(), 0.9, 0.02);
}

}  // namespace
}  // namespace lookout::tracking
