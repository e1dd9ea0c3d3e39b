#include "tools/experiments/compare/compared_run.hpp"

#include <gtest/gtest.h>

#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

// One target ahead, no misses, no false alarms: a tracker cannot fail.
constexpr const char* kEasyScene =
    "duration: 20\n"
    "sonar: {range_sigma: 0.5, miss_probability: 0.0, false_alarm_probability: 0.0}\n"
    "targets: [{id: 1, north: 50, east: 0, north_velocity: 0.5, east_velocity: 0.2}]\n";

TEST(ComparedRun, AnEasyTargetIsFollowedAndRunsDiffer) {
  const tests::TemporaryDirectory folder;
  const auto scenes = compared_scenes({folder.write("easy.yaml", kEasyScene)});
  ASSERT_EQ(scenes.size(), 1U);
  EXPECT_EQ(scenes[0].name, "easy");
  Options options;
  options.tracker = "gnn";
  Configuration configuration = load_configuration(options);
  configuration.sensor = told_params(scenes[0].scene, scenes[0].view.seen, options);
  const Curve first = compared_run(scenes[0], configuration, {}, 1000, 0);
  const Curve second = compared_run(scenes[0], configuration, {}, 1000, 1);
  EXPECT_EQ(first.utime.size(), 40U);  // 20 s at 0.5 s
  EXPECT_EQ(first["num_tracks"].back(), 1.0);
  EXPECT_LT(first["ospa"].back(), 5.0);
  EXPECT_NE(first["ospa"].back(), second["ospa"].back());
  EXPECT_EQ(first["ospa"], compared_run(scenes[0], configuration, {}, 1000, 0)["ospa"]);
  EXPECT_GT(first.time_ms, 0.0);
}

TEST(ComparedRun, EachSonarOfAVehicleIsASceneOfItsOwn) {
  const auto scenes =
      compared_scenes({"tools/scenarios/two_uuv.yaml", "tools/scenarios/sea_two_sonars.yaml"});
  ASSERT_GE(scenes.size(), 4U);
  EXPECT_TRUE(scenes[0].name.starts_with("two_uuv/node"));
  EXPECT_TRUE(scenes[2].name.starts_with("sea_two_sonars/sonar"));
}

TEST(ComparedRun, TwoScenesOfOneNameAreRefused) {
  const tests::TemporaryDirectory folder;
  const std::string file = folder.write("easy.yaml", kEasyScene);
  EXPECT_NE(testing::error_of([&] {
              compared_scenes({file, file});
            }).find("is there already"),
            std::string::npos);
}

}  // namespace
}  // namespace lookout::tools
