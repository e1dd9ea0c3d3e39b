#include "sonar_sim/scene.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/input_error.hpp"
#include "tests/sonar_sim/scene_error.hpp"

namespace lookout::sonar_sim {
namespace {

const std::string kScenarios = LOOKOUT_SOURCE_DIR "/tools/scenarios/";

TEST(Scene, EveryShippedSceneLoads) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kScenarios)) {
    if (entry.is_directory()) continue;  // Plans of faults, which are no scenes.
    EXPECT_NO_THROW(load_scene(entry.path().string())) << entry.path();
    ++scenes;
  }
  EXPECT_GE(scenes, 8);
}

TEST(Scene, TableSevenAsPrinted) {
  const Scene scene = load_scene(kScenarios + "tracking_table7.yaml");
  const PlatformPlan& platform = scene.platforms.at(0);
  EXPECT_EQ(num_scans(scene, platform), 200);  // 100 s at 0.5 s
  EXPECT_EQ(scene.targets.size(), 5u);
  EXPECT_EQ(scene.targets[3].appear, 22.0);
}

TEST(Scene, TargetsOfTableSevenLeaveTheSectorEarly) {
  // With the heading along the velocity targets 1, 3 and 4 leave the sector at 60.0, 52.0 and 82.0 s.
  const Scene scene = load_scene(kScenarios + "tracking_table7.yaml");
  const VehicleMotion motion(scene.platforms[0].vehicle);
  const auto visible = [&](int id, double time) {
    for (const auto& target : truth_at(scene, scene.platforms[0], motion, time).targets)
      if (target.id == id) return target.visible;
    return false;
  };
  EXPECT_TRUE(visible(1, 59.5));
  EXPECT_FALSE(visible(1, 60.5));
  EXPECT_TRUE(visible(3, 51.5));
  EXPECT_FALSE(visible(3, 52.5));
  EXPECT_TRUE(visible(4, 81.5));
  EXPECT_FALSE(visible(4, 82.5));
}

TEST(Scene, MeanVisibleTargets) {
  // Table 2: all three, always. Table 7, by hand from the times in view: (59 + 99 + 51 + 60 + 68) s of 100 s.
  const Scene window = load_scene(kScenarios + "window_table2.yaml");
  EXPECT_DOUBLE_EQ(mean_visible_targets(window, window.platforms[0]), 3.0);
  const Scene tracking = load_scene(kScenarios + "tracking_table7.yaml");
  EXPECT_NEAR(mean_visible_targets(tracking, tracking.platforms[0]), 3.37, 0.03);
}

TEST(Scene, LightClutterIsToldAsAnEquivalentRate) {
  Scene scene = load_scene(kScenarios + "window_table2.yaml");
  scene.platforms[0].sonar.clutter = ClutterReading::light;
  // .3 / .7 * .7 * 3 / 87 by hand
  EXPECT_NEAR(*known_params(scene, scene.platforms[0]).false_alarm_probability, 0.9 / 87.0, 1e-12);
}

TEST(Scene, SeveralVehicles) {
  const Scene scene = parse_scene(
      "duration: 5\nvehicles:\n"
      "  - {channel_prefix: A_, node_id: 7, vehicle: {}, sonar: {miss_probability: 0, "
      "false_alarm_probability: 0}}\n"
      "  - {channel_prefix: B_, vehicle: {north: 5}, sonar: {miss_probability: 0, clutter_per_scan: 2}}\n",
      "two");
  ASSERT_EQ(scene.platforms.size(), 2u);
  EXPECT_EQ(scene.platforms[0].node_id, 7);
  EXPECT_EQ(scene.platforms[1].node_id, 2);
  EXPECT_TRUE(scene.platforms[1].sonar.params.point_sensor());
}

/// The error of a scene whose sonar stands in line 2 with these keys too.
std::string sonar_error(const std::string& keys) {
  return error_of("duration: 5\nsonar: {miss_probability: 0, false_alarm_probability: 0, " + keys + "}\n");
}

TEST(Scene, UnevenBeamsGiveNumberFirstAndMeanStep) {
  const Scene scene = parse_scene(
      "duration: 5\nsonar: {miss_probability: 0, false_alarm_probability: 0, beam_bearings_deg: [-5, 0, "
      "7]}\n",
      "scene.yaml");
  const core::SonarParams& params = scene.platforms[0].sonar.params;
  EXPECT_EQ(params.num_beams, 3);
  EXPECT_DOUBLE_EQ(params.first_bearing, core::radians(-5.0));
  EXPECT_DOUBLE_EQ(params.bearing_step, core::radians(6.0));
}

TEST(Scene, ContradictionsOfASonarNameTheirPlace) {
  const auto says = [](const std::string& error, const std::string& words) {
    EXPECT_NE(error.find("scene.yaml:2:"), std::string::npos) << error;
    EXPECT_NE(error.find(words), std::string::npos) << error;
  };
  says(sonar_error("beam_bearings_deg: [0, 1], bearing_step_deg: 1"), "excludes first_bearing_deg");
  says(sonar_error("beam_bearings_deg: [0, 1], num_beams: 3"), "is not the number of beam_bearings_deg");
  says(sonar_error("beam_bearings_deg: [1, 0, 2]"), "bearings that rise or fall");
  says(sonar_error("range_settings: [{time: 5, max_range: 9}, {time: 5, max_range: 8}]"), "must be later");
  says(sonar_error("returns_per_beam: 0"), "returns_per_beam: got `0`");
  says(sonar_error("returns_per_beam: 1000, num_beams: 360"), "num_beams x returns_per_beam is above");
  says(sonar_error("keep: loudest"), "expected one of: precedence nearest strongest");
  says(error_of("duration: 5\nsonar: {miss_probability: 0, clutter_per_scan: 1, keep: nearest}\n"),
       "keep: is of sonars with beams");
  says(error_of("duration: 5\nsonars: [{miss_probability: 0, clutter_per_scan: 1, sensor_id: 2}, "
                "{miss_probability: 0, clutter_per_scan: 1}]\n"),
       "sensor_id: is used twice");
}

TEST(Scene, ASonarThatNeverPingsIsAnError) {
  EXPECT_NE(error_of("duration: 5\nsonar: {miss_probability: 0, false_alarm_probability: 0, first_scan: 5}\n")
                .find("scene.yaml:1:11: duration: ends before the first_scan"),
            std::string::npos);
}

TEST(Scene, ATargetIsVisibleWhereOneSonarOfTheVehicleSeesIt) {
  const std::string keys = "miss_probability: 0, false_alarm_probability: 0";
  const Scene scene =
      parse_scene("duration: 5\nsonars: [{" + keys + "}, {" + keys +
                      ", mount_heading_deg: 180, max_range: 50,\n"
                      "range_settings: [{time: 2, max_range: 20}]}]\n"
                      "targets: [{id: 1, north: 60, east: 0}, {id: 2, north: -30, east: 0}]\n",
                  "scene.yaml");
  const VehicleMotion motion(scene.platforms[0].vehicle);
  const auto early = truth_at(scene, scene.platforms[0], motion, 1.0);
  EXPECT_TRUE(early.targets[0].visible);
  EXPECT_TRUE(early.targets[1].visible);
  EXPECT_FALSE(truth_at(scene, scene.platforms[0], motion, 2.0).targets[1].visible);
}

TEST(Scene, ErrorsNamePlaceAndWhatIsAccepted) {
  const std::string sonar = "sonar: {miss_probability: 0, false_alarm_probability: 0}\n";
  EXPECT_EQ(error_of(sonar), "scene.yaml:1:1: duration: is missing, expected a number > 0 <= 1e+06");
  EXPECT_NE(error_of("duration: 5\n" + sonar + "tragets: []\n").find("scene.yaml:3:1: unknown key `tragets`"),
            std::string::npos);
  EXPECT_NE(error_of("duration: -5\n" + sonar).find("scene.yaml:1:11: duration: got `-5`"),
            std::string::npos);
  EXPECT_NE(error_of("duration: 5\nsonar: {latency: 1}\n").find("latency: is of real sensors"),
            std::string::npos);
  EXPECT_NE(error_of("duration: 5\nsonar: {resolution: 1}\n").find("resolution: is of real sensors"),
            std::string::npos);
  EXPECT_NE(error_of("duration: 5\nsonar: {miss_probability: 0}\n").find("false_alarm_probability"),
            std::string::npos);
  EXPECT_NE(error_of("duration: 5\n" + sonar +
                     "targets: [{id: 1, north: 0, east: 0}, {id: 1, north: 0, east: 0}]\n")
                .find("id: is used twice"),
            std::string::npos);
  EXPECT_NE(error_of("duration: 5\n" + sonar + "sonars: []\n")
                .find("scene.yaml:3:9: sonars: stands in place of sonar"),
            std::string::npos);
  EXPECT_NE(error_of("duration: 5 s\n" + sonar).find("expected a number"), std::string::npos);
}

}  // namespace
}  // namespace lookout::sonar_sim
