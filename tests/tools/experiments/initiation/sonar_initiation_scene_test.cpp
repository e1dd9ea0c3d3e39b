#include "tools/experiments/initiation/sonar_initiation_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lookout::tools {
namespace {

TEST(SonarInitiationScene, WithoutClutterAlmostEveryDetectionIsATargets) {
  SceneVariant variant;
  variant.p_false_alarm = 1e-6;
  variant.p_miss = 1e-6;
  const SonarInitiation made = sonar_initiation("window_table2.yaml", variant, 1001, 0);
  EXPECT_EQ(made.scene.num_targets, 3);  // [Yan2018] Table 2.
  EXPECT_EQ(made.scene.scans.size(), made.scene.times.size());
  const auto strange = std::count(made.scene.target_of.begin(), made.scene.target_of.end(), -1);
  // A gate of 99.9 %: 60 detections leave it 0.06 times on average.
  EXPECT_GE(made.scene.target_of.size(), 55u);
  EXPECT_LE(strange, 1);
}

TEST(SonarInitiationScene, WithClutterMostDetectionsAreNobodys) {
  SceneVariant variant;
  variant.p_false_alarm = 0.3;
  const SonarInitiation made = sonar_initiation("window_table2.yaml", variant, 1001, 0);
  const auto strange = std::count(made.scene.target_of.begin(), made.scene.target_of.end(), -1);
  // 90 beams with P_F = .3 in 20 scans: 540 false alarms, of which few lie within a gate by chance.
  EXPECT_NEAR(static_cast<double>(strange), 540.0, 3.0 * std::sqrt(540.0) + 20.0);
}

}  // namespace
}  // namespace lookout::tools
