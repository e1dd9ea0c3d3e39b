#include "sonar_sim/sea/sea_reader.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "sonar_sim/scene.hpp"
#include "tests/sonar_sim/scene_error.hpp"

namespace lookout::sonar_sim {
namespace {

const std::string kSonar = "sonar: {miss_probability: 0.1, false_alarm_probability: 0.1}\n";

SeaPlan sea_of(const std::string& sea) {
  return parse_scene("duration: 5\n" + kSonar + "sea:\n" + sea, "scene.yaml").platforms[0].sonar.sea;
}

/// The error of a scene whose `sea` begins in line 4.
std::string sea_error(const std::string& sea) {
  return error_of("duration: 5\n" + kSonar + "sea:\n" + sea);
}

TEST(SeaReader, ReadsEveryPartInTheUnitsOfThePlan) {
  const SeaPlan plan = sea_of(
      "  echo_probability: {range_loss: 0.6, aspect_loss: 0.2}\n"
      "  heavy_tails: {degrees_of_freedom: 3}\n"
      "  spill: {probabilities: [0.7, 0.3], range_sigma: 2, loss_db: [3], of: all}\n"
      "  standing:\n"
      "    points: [{north: 1, east: 2}]\n"
      "    lines: [{from: [0, 60], to: [100, 60]}]\n"
      "    arcs: [{north: 9, east: 8, radius: 7, azimuths_deg: [-90, 90], snr_db: 20}]\n"
      "    fields: [{count: 12, north: [0, 140], east: [-70, 70], probability: 0.5}]\n"
      "  patches: [{bearings_deg: [5, 25], ranges: [60, 90], probability: 0.9},\n"
      "            {frame: earth, north: 3, east: 4, radius: 5, mean_returns: 6}]\n"
      "  bottom: {range: 100, wave: 5}\n"
      "  bursts: [{start: 30, duration: 3, factor: 10}]\n"
      "  fluctuation: {swerling: 3, snr_db: 10, threshold: 1}\n"
      "  scan_loss: {empty: 0.2}\n");
  EXPECT_EQ(plan.echo_probability->reference_range, 150.0);  // the sonar's
  EXPECT_EQ(plan.spill->probabilities, (std::vector{0.7, 0.3}));
  EXPECT_TRUE(plan.spill->standing);
  EXPECT_EQ(plan.standing.lines.at(0).echo.probability, 0.8);
  EXPECT_DOUBLE_EQ(plan.standing.arcs.at(0).first_azimuth, core::radians(-90.0));
  EXPECT_EQ(plan.standing.fields.at(0).north_east, Eigen::Vector2d(140.0, 70.0));
  EXPECT_DOUBLE_EQ(plan.patches.at(0).last_bearing, core::radians(25.0));
  EXPECT_TRUE(plan.patches.at(1).on_earth);
  EXPECT_EQ(plan.bottom->wave, 5.0);
  EXPECT_EQ(plan.bursts.at(0).factor, 10.0);
  EXPECT_EQ(plan.fluctuation->swerling, 3);
  EXPECT_EQ(plan.scan_loss->empty, 0.2);
}

TEST(SeaReader, ASonarsOwnSeaChangesTheScenesKeyByKey) {
  const Scene scene = parse_scene(
      "duration: 5\n"
      "sonars:\n"
      "  - {miss_probability: 0, false_alarm_probability: 0}\n"
      "  - {miss_probability: 0, false_alarm_probability: 0, sea: {bottom: {range: 40}, patches: []}}\n"
      "sea: {bottom: {range: 100}, scan_loss: {empty: 0.2},\n"
      "      patches: [{bearings_deg: [5, 25], ranges: [60, 90], probability: 0.9}]}\n",
      "scene.yaml");
  const SeaPlan &first = scene.platforms[0].sonar.sea, &second = scene.platforms[0].further_sonars.at(0).sea;
  EXPECT_EQ(first.bottom->range, 100.0);
  EXPECT_EQ(first.patches.size(), 1u);
  EXPECT_EQ(second.bottom->range, 40.0);
  EXPECT_TRUE(second.patches.empty());
  EXPECT_EQ(second.scan_loss->empty, 0.2);
}

TEST(SeaReader, UnknownKeysAndValuesOutOfRangeNameTheirPlace) {
  EXPECT_NE(sea_error("  botom: {}\n").find("scene.yaml:4:3: unknown key `botom`, accepted:"),
            std::string::npos);
  EXPECT_NE(sea_error("  bottom: {probability: 2}\n").find("scene.yaml:4:25: probability: got `2`"),
            std::string::npos);
  EXPECT_NE(
      sea_error("  spill: {probabilities: [0.7, 1.3]}\n").find("scene.yaml:4:26: probabilities: expected"),
      std::string::npos);
  EXPECT_NE(sea_error("  spill: {}\n").find("probabilities: is missing"), std::string::npos);
  EXPECT_NE(sea_error("  bursts: [{start: 1}]\n").find("duration: is missing"), std::string::npos);
  EXPECT_NE(sea_error("  fluctuation: {swerling: 5}\n").find("scene.yaml:4:27: swerling"), std::string::npos);
  EXPECT_NE(sea_error("  standing: {fields: [{north: [0, 1], east: [0, 1]}]}\n").find("count: is missing"),
            std::string::npos);
}

TEST(SeaReader, ContradictionsNameTheirPlace) {
  const std::string patch = "  patches: [{bearings_deg: [5, 25], ranges: [60, 90]";
  EXPECT_NE(sea_error(patch + "}]\n").find("probability: expected either it or mean_returns"),
            std::string::npos);
  EXPECT_NE(
      sea_error(patch + ", probability: 0.5, mean_returns: 3}]\n").find("expected either it or mean_returns"),
      std::string::npos);
  EXPECT_NE(sea_error(patch + ", frame: earth, north: 1, east: 1, radius: 1, probability: 1}]\n")
                .find("unknown key `bearings_deg`"),
            std::string::npos);
  EXPECT_NE(sea_error("  patches: [{bearings_deg: [25, 5], ranges: [60, 90], probability: 1}]\n")
                .find("scene.yaml:4:28: bearings_deg: expected [from, to]"),
            std::string::npos);
  EXPECT_NE(sea_error("  standing: {lines: [{from: [1, 2], to: [1, 2]}]}\n").find("is where the line begins"),
            std::string::npos);
  EXPECT_NE(sea_error("  echo_probability: {range_exponent: 2}\n").find("range_loss: is missing or 0"),
            std::string::npos);
  EXPECT_NE(sea_error("  bursts: [{start: 1, duration: 1}]\n").find("expected either it or factor"),
            std::string::npos);
}

TEST(SeaReader, ABurstMustFitItsSonar) {
  const std::string burst = "sea: {bursts: [{start: 1, duration: 1, false_alarm_probability: 1}]}\n";
  EXPECT_NE(error_of("duration: 5\n" + burst + "sonar: {miss_probability: 0, clutter_per_scan: 2}\n")
                .find("scene.yaml:2:15: bursts: false_alarm_probability is of sonars with beams"),
            std::string::npos);
  EXPECT_NE(error_of("duration: 5\n" + burst +
                     "sonar: {miss_probability: 0, false_alarm_probability: 0.1, clutter: light}\n")
                .find("must stay below 1 under light clutter"),
            std::string::npos);
}

TEST(SeaReader, StrongestNeedsIntensities) {
  EXPECT_NE(
      error_of("duration: 5\nsonar: {miss_probability: 0, false_alarm_probability: 0, keep: strongest}\n")
          .find("scene.yaml:2:64: keep: strongest needs"),
      std::string::npos);
}

}  // namespace
}  // namespace lookout::sonar_sim
