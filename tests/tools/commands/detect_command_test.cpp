#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "core/files/image_recording.hpp"
#include "core/files/recording.hpp"
#include "core/files/text_file.hpp"
#include "core/input_error.hpp"
#include "tests/support/speckle_images.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tools/cli/configuration.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

constexpr int kPings = 30;

/// A recording of images with one target that closes from beam 40, bin 300 by a bin a ping, and its truth.
void write_images(const std::string& directory) {
  const lookout::testing::SpecklePlan plan;
  lookout::testing::SpeckleImages images(plan, 12);
  core::Recording recording;
  core::ImageWriter writer(directory);
  for (int ping = 0; ping < kPings; ++ping) {
    core::SonarImage image = images.next({{40.0, 300.0 - ping, 22.0}});
    core::quantise(image, 32767.0);
    writer.add(image);
    core::TargetTruth target;
    const double bearing = plan.first_bearing + 40.0 * plan.bearing_step;
    const double range = plan.first_range + (300.0 - ping) * plan.range_step;
    target.position = {range * std::cos(bearing), range * std::sin(bearing)};
    recording.truth.push_back({image.utime, {target}});
  }
  writer.close();
  recording.is_fixed = true;
  recording.has_images = true;
  core::write_recording(directory, recording);
}

class DetectCommand : public ::testing::Test {
 protected:
  DetectCommand() {
    in_ = directory_.path() + "/images";
    out_ = directory_.path() + "/returns";
    write_images(in_);
    options_.inputs = {in_};
    options_.out = out_;
  }
  std::string refusal() const {
    try {
      detect_command(options_);
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "";
  }

  lookout::tests::TemporaryDirectory directory_;
  std::string in_, out_;
  Options options_;
};

TEST_F(DetectCommand, MakesARecordingOfReturnsWithMeasuredFigures) {
  EXPECT_EQ(detect_command(options_), 0);
  const core::Recording recording = core::read_recording(out_);
  ASSERT_EQ(recording.scans.size(), static_cast<std::size_t>(kPings));
  EXPECT_EQ(recording.truth.size(), static_cast<std::size_t>(kPings));
  ASSERT_TRUE(recording.params);
  EXPECT_LT(recording.params->miss_probability.value(), 0.1);
  EXPECT_LT(recording.params->range_sigma, 0.02);  // 22 dB: a tenth of a bin of 0.1 m, with room.
  const auto figures = nlohmann::json::parse(core::read_text_file(out_ + "/detection.json", "JSON"));
  EXPECT_EQ(figures["images"], kPings);
  EXPECT_EQ(figures["measured"]["targets"], kPings);
}

TEST_F(DetectCommand, RefusesWhatWouldDoNothing) {
  options_.out = in_;
  EXPECT_NE(refusal().find("--out"), std::string::npos);
  options_.out.clear();
  EXPECT_NE(refusal().find("--out"), std::string::npos);
  options_.out = out_;
  options_.duration = 3.0;
  EXPECT_NE(refusal().find("--duration"), std::string::npos);
  options_.duration.reset();
  options_.channel_prefix = "AUV1_";
  EXPECT_NE(refusal().find("--channel-prefix"), std::string::npos);
}

TEST_F(DetectCommand, ADirectoryWithoutImagesIsRefused) {
  options_.inputs = {directory_.path()};
  EXPECT_NE(refusal().find("images.csv"), std::string::npos);
}

TEST_F(DetectCommand, ReplayTracksItsScansAsItTracksTheImages) {
  detect_command(options_);
  Options images;
  images.inputs = {in_};
  images.out = directory_.path() + "/tracked";
  images.input = "image";
  EXPECT_EQ(replay_command(images), 0);
  EXPECT_EQ(core::read_tracks(images.out + "/tracks.csv").empty(), false);
}

TEST(InputFlag, ChoosesWhatIsTracked) {
  Options options;
  EXPECT_FALSE(takes_images(load_configuration(options)));
  options.input = "image";
  EXPECT_TRUE(load_configuration(options).detects);
  options.estimator = "h_pmht";
  EXPECT_FALSE(load_configuration(options).detects);
  EXPECT_TRUE(takes_images(load_configuration(options)));
  options.input = "picture";
  EXPECT_THROW(load_configuration(options), core::InputError);
}

TEST(DetectConfiguration, ItsPartIsReadAndTheSensorsGivenFiguresAreKnown) {
  const lookout::tests::TemporaryDirectory directory;
  Options options;
  options.config = directory.write(
      "c.yaml", "detect: {method: cell_averaging, false_alarm_rate: 0.02}\nsensor: {range_sigma: 0.4}\n");
  const Configuration configuration = load_configuration(options);
  EXPECT_EQ(configuration.detection.reference.method, "cell_averaging");
  EXPECT_EQ(configuration.detection.false_alarm.rate, 0.02);
  EXPECT_TRUE(configuration.given.range_sigma);
  EXPECT_FALSE(configuration.given.bearing_sigma);
}

TEST(DetectConfiguration, WhatASceneSaysOfItsOwnReturnsSaysNothingOfOurs) {
  core::SonarParams known, configured;
  known.miss_probability = 0.3;
  known.false_alarm_probability = 0.2;
  known.max_speed = 9.0;
  known.heading_sigma = 0.01;
  configured.range_sigma = 0.5;
  const core::SonarParams params = params_of_images(known, configured);
  EXPECT_FALSE(params.miss_probability);
  EXPECT_FALSE(params.false_alarm_probability);
  EXPECT_EQ(params.range_sigma, 0.5);
  EXPECT_EQ(params.max_speed, 9.0);
  EXPECT_EQ(params.heading_sigma, 0.01);
}

}  // namespace
}  // namespace lookout::tools
