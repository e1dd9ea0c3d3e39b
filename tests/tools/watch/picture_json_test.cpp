#include "tools/watch/picture_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/beam_bearings.hpp"
#include "tests/tools/watch/watch_examples.hpp"

namespace lookout::tools {
namespace {

TEST(Ellipse95, HasTheAxesOfADiagonalCovariance) {
  Eigen::Matrix2d covariance;
  covariance << 1.0, 0.0, 0.0, 4.0;  // The greater variance to the east.
  const Ellipse ellipse = ellipse_95(covariance);
  EXPECT_NEAR(ellipse.major, 2.0 * std::sqrt(5.991464547), 1e-8);  // sqrt(-2 ln 0.05 * variance)
  EXPECT_NEAR(ellipse.minor, std::sqrt(5.991464547), 1e-8);
  EXPECT_NEAR(std::abs(ellipse.heading), std::numbers::pi / 2.0, 1e-8);
}

TEST(Ellipse95, TurnsWithTheCovariance) {
  Eigen::Matrix2d covariance;
  covariance << 2.5, 1.5, 1.5, 2.5;  // Variances 4 and 1, the greater one to the north-east.
  EXPECT_NEAR(std::remainder(ellipse_95(covariance).heading, std::numbers::pi), std::numbers::pi / 4.0, 1e-8);
}

TEST(Ellipse95, IsNothingForWhatIsNoCovariance) {
  Eigen::Matrix2d covariance;
  covariance << -1.0, 0.0, 0.0, 1.0;
  EXPECT_EQ(ellipse_95(covariance).major, 0.0);
  covariance(0, 0) = std::nan("");
  EXPECT_EQ(ellipse_95(covariance).major, 0.0);
}

TEST(PictureJson, OfATrackHasItsStateRounded) {
  core::Track track = tests::example_track(7);
  track.state << 1.23456, 2.0, -0.5, 0.25;
  track.covariance.setIdentity();
  const auto json = to_json(track);
  EXPECT_EQ(json["id"], 7);
  EXPECT_EQ(json["status"], "coasting");
  EXPECT_EQ(json["north"], 1.235);
  EXPECT_EQ(json["velocity"], nlohmann::json({-0.5, 0.25}));
  EXPECT_EQ(json["ellipse"][0], 2.448);  // sqrt(5.991)
  EXPECT_EQ(json["last_detection_utime"], 1'500'000);
}

TEST(PictureJson, OfAScanHasReturnsEdgesAndPose) {
  const auto json = to_json(Placed<core::SonarScan>{tests::example_scan(), core::Pose2{1.0, 2.0, 0.5}});
  EXPECT_EQ(json["returns"], nlohmann::json({-0.5, 30.0, 0.25, 120.5}));
  EXPECT_EQ(json["pose"], nlohmann::json({{"north", 1.0}, {"east", 2.0}, {"heading", 0.5}}));
  EXPECT_NEAR(json["edges"][0], -0.75 - 0.0175 / 2, 1e-4);
  EXPECT_NEAR(json["edges"][1], -0.75 + 89.5 * 0.0175, 1e-4);
  EXPECT_TRUE(to_json(Placed<core::SonarScan>{tests::example_scan(), std::nullopt})["pose"].is_null());
}

TEST(PictureJson, OfAClutterMapHasItsCellsAndPose) {
  Heard heard("");
  say(heard, "CLUTTER_MAP", lcmtypes::to_wire(tests::example_clutter_grid()));
  const auto json = picture_of(heard, Topic::clutter, at_second(0.0));
  EXPECT_EQ(json["density"], nlohmann::json({0, 1, 20, 30, 126, 127}));
  EXPECT_EQ(json["num_ranges"], 2);
  EXPECT_EQ(json["pose"], nlohmann::json({{"north", 1.5}, {"east", -2.5}, {"heading", 0.25}}));
  EXPECT_EQ(json["bearing_step"], 0.5);
}

TEST(PictureJson, ReducesALargeImageToItsStrongestEchoes) {
  core::SonarImage image = tests::example_image();
  image.bearings = core::even_bearings(-0.5, 0.003, 2 * kMaxShownBeams);
  image.num_bins = 2 * kMaxShownBins;
  image.intensity.assign(static_cast<std::size_t>(image.num_beams() * image.num_bins), 0.0);
  image.intensity[1] = 5.0;  // Beam 0, bin 1: falls into the first block.
  const auto json = to_json(Placed<core::SonarImage>{image, std::nullopt});
  EXPECT_NEAR(json["edges"][0], -0.5 - 0.0015, 1e-4);  // Half a beam outside the outer centres.
  EXPECT_NEAR(json["edges"][1], -0.5 + (2 * kMaxShownBeams - 0.5) * 0.003, 1e-4);
  EXPECT_EQ(json["beams"], kMaxShownBeams);
  EXPECT_EQ(json["bins"], kMaxShownBins);
  const std::string pixels = json["pixels"];
  EXPECT_EQ(pixels.substr(0, 4), "/wAA");  // Base64 of the bytes 255, 0, 0.
  EXPECT_EQ(pixels.size(), (kMaxShownBeams * kMaxShownBins + 2) / 3 * 4u);
}

TEST(PictureJson, OfEveryTopicIsThereOnceItWasHeard) {
  Heard heard("");
  EXPECT_TRUE(picture_of(heard, Topic::tracks, at_second(0.0)).is_null());
  say_healthy(heard, 3);
  say(heard, "GROUND_TRUTH", lcmtypes::to_wire(tests::example_truth()));
  EXPECT_EQ(picture_of(heard, Topic::tracks, at_second(1.0))["tracks"].size(), 1u);
  EXPECT_EQ(picture_of(heard, Topic::truth, at_second(1.0))["targets"][1]["visible"], false);
  EXPECT_EQ(picture_of(heard, Topic::vehicle, at_second(1.0))["north"], 10.0);
  const auto status = picture_of(heard, Topic::status, at_second(1.0));
  EXPECT_EQ(status["nodes"][0]["node"], "lookout track");
  EXPECT_EQ(status["complaints"].size(), 0u);
  EXPECT_EQ(status["channels"].size(), kNumTopics);
}

TEST(PictureJson, OfTrailsIsByTrack) {
  Heard heard("");
  say_healthy(heard, 4);  // Half a second apart.
  const auto json = to_json(heard.trails());
  EXPECT_EQ(json["7"].size(), 4u);
  EXPECT_EQ(json["7"][2], nlohmann::json({1.0, 1.0, 2.0, 0.75}));  // Time, then the example track's place.
}

TEST(LineOf, IsOneLineOfUtf8Whatever) {
  EXPECT_EQ(line_of({{"text", "a\nb\xff"}}), "{\"text\":\"a\\nb\xef\xbf\xbd\"}");
}

}  // namespace
}  // namespace lookout::tools
