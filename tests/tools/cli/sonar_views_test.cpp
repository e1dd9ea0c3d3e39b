#include "tools/cli/sonar_views.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

sonar_sim::Scene scene_of(const std::string& text) {
  return sonar_sim::parse_scene(text, "scene.yaml");
}

TEST(SonarViews, OneSonarNeedsNoFolder) {
  const auto views =
      sonar_views(scene_of("duration: 1\nsonar: {miss_probability: 0.1, false_alarm_probability: 0.1}\n"));
  ASSERT_EQ(views.size(), 1U);
  EXPECT_EQ(views[0].folder, "");
  EXPECT_EQ(views[0].seen.sonar.sensor_id, 1);
}

TEST(SonarViews, EachVehicleHasItsFolder) {
  const auto views = sonar_views(sonar_sim::load_scene("tools/scenarios/two_uuv.yaml"));
  ASSERT_EQ(views.size(), 2U);
  EXPECT_EQ(views[0].folder, "/node1");
  EXPECT_EQ(views[1].platform, 1U);
}

TEST(SonarViews, SonarsOfAVehicleAreSeenOneByOne) {
  const auto scene = sonar_sim::load_scene("tools/scenarios/sea_two_sonars.yaml");
  const auto views = sonar_views(scene);
  ASSERT_EQ(views.size(), 2U);
  EXPECT_TRUE(views[1].folder.starts_with("/sonar"));
  EXPECT_TRUE(views[1].seen.further_sonars.empty());
  EXPECT_EQ(sonar_views(scene, true).size(), 1U);
}

TEST(SonarViews, TheSceneTellsUnlessItIsToBeUnknown) {
  const auto scene = scene_of(
      "duration: 1\nsonar: {range_sigma: 0.5, num_beams: 33, miss_probability: 0.1, false_alarm_probability: "
      "0.1}\n");
  const auto view = sonar_views(scene)[0];
  Options options;
  EXPECT_EQ(told_params(scene, view.seen, options).range_sigma, 0.5);
  options.unknown_sensor = true;
  EXPECT_EQ(told_params(scene, view.seen, options).range_sigma, core::SonarParams{}.range_sigma);
  EXPECT_EQ(told_params(scene, view.seen, options).num_beams, 33);  // the scans show it
}

}  // namespace
}  // namespace lookout::tools
