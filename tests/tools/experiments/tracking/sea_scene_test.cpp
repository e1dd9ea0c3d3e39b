#include "tools/experiments/tracking/sea_scene.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

TEST(SeaScene, EveryConditionOfARunHasTheSameTargets) {
  const auto first = sea_scene({"uniform"}, 1000, 3);
  for (const char* condition : sea_conditions()) {
    const auto scene = sea_scene({condition, "staying", 0.3, 0.2}, 1000, 3);
    EXPECT_EQ(scene.platforms[0].sonar.params.false_alarm_probability, 0.3);
    ASSERT_EQ(scene.targets.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(scene.targets[i].position, first.targets[i].position);
  }
}

TEST(SeaScene, TargetsComeInViewAtTheirSpeeds) {
  for (const char* targets : sea_targets())
    for (int run = 0; run < 20; ++run) {
      const auto scene = sea_scene({"uniform", targets}, 1000, run);
      const auto& platform = scene.platforms[0];
      const sonar_sim::VehicleMotion motion(platform.vehicle);
      for (const auto& target : scene.targets) {
        EXPECT_GE(target.velocity.norm(), 0.8);
        EXPECT_LE(target.velocity.norm(), 1.3);
        const auto truth = truth_at(scene, platform, motion, target.appear);
        for (const auto& seen : truth.targets) EXPECT_TRUE(seen.id != target.id || seen.visible);
      }
    }
}

TEST(SeaScene, NearTargetsComeAtFortyToEightyMetres) {
  for (int run = 0; run < 20; ++run) {
    const auto scene = sea_scene({"uniform", "near"}, 1000, run);
    const sonar_sim::VehicleMotion motion(scene.platforms[0].vehicle);
    for (const auto& target : scene.targets) {
      const auto vehicle = motion.at(target.appear).T_earth_body;
      const Eigen::Vector2d first = target_state(target, target.appear).position;
      const double range = (first - Eigen::Vector2d(vehicle.north, vehicle.east)).norm();
      EXPECT_GE(range, 40.0 - 1e-6);
      EXPECT_LE(range, 80.0 + 1e-6);
    }
  }
}

TEST(SeaScene, TargetsOfAnotherNameAreRefused) {
  EXPECT_THROW(sea_scene({"uniform", "far"}, 1000, 0), core::InputError);
}

TEST(SeaScene, RunsDiffer) {
  EXPECT_NE(sea_scene({"wall"}, 1000, 0).targets[0].position,
            sea_scene({"wall"}, 1000, 1).targets[0].position);
}

}  // namespace
}  // namespace lookout::tools
