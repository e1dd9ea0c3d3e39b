#include "tools/experiments/track_before_detect/image_sea_scene.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

TEST(ImageSeaScene, EveryConditionHasItsLevelItsBinsAndTheSameTargets) {
  const auto first = image_sea_scene("plain", {8.0, 0.2}, 401, 3);
  for (const std::string condition : image_sea_conditions()) {
    const auto scene = image_sea_scene(condition, {8.0, 0.2}, 401, 3);
    const auto& image = *scene.platforms.front().image;
    EXPECT_EQ(image.snr_db, 8.0);
    EXPECT_EQ(image.num_bins, 300) << condition;  // 60 m
    ASSERT_EQ(scene.targets.size(), condition == "empty" ? 0u : 3u);
    if (condition == "uneven" || condition == "empty") continue;  // a narrower fan; none
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(scene.targets[i].position, first.targets[i].position);
  }
}

TEST(ImageSeaScene, RunsDifferAndTargetsKeepTheirSpeeds) {
  for (int run = 0; run < 10; ++run)
    for (const auto& target : image_sea_scene("uneven", {}, 401, run).targets) {
      EXPECT_GE(target.velocity.norm(), 0.4);
      EXPECT_LE(target.velocity.norm(), 1.2);
    }
  EXPECT_NE(image_sea_scene("plain", {}, 401, 0).targets[0].position,
            image_sea_scene("plain", {}, 401, 1).targets[0].position);
}

TEST(ImageSeaScene, RefusesAConditionWithoutAScene) {
  EXPECT_THROW(image_sea_scene("storm", {}, 401, 0), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
