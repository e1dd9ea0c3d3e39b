#include "tools/cli/logs/log_recording.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/input_error.hpp"
#include "tests/lcmtypes/example_messages.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tools/cli/logs/replay_log.hpp"

namespace lookout::tools {
namespace {

/// One scan between two vehicle states, and its truth.
core::Recording example_recording() {
  core::Recording recording;
  recording.scans = {tests::example_scan()};
  recording.truth = {tests::example_truth()};
  recording.vehicle = {tests::example_state(), tests::example_state()};
  recording.vehicle[1].utime = 2'500'000;
  recording.vehicle[1].T_earth_body.north +=
      0.5;  // As its velocity says: a pose that stands is not believed.
  return recording;
}

TEST(LogRecording, ReadsBackAsItWasWritten) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.file("dive.lcmlog");
  const std::vector<core::TrackList> tracks{{2'000'000, {tests::example_track(7)}}};
  write_log(path, example_recording(), tracks, "AUV1_");

  LogFigures figures;
  const core::Recording back = read_log({path}, "AUV1_", {}, figures);
  ASSERT_EQ(back.scans.size(), 1u);
  EXPECT_EQ(back.scans[0].sequence, 4);
  EXPECT_EQ(back.scans[0].returns[1].range, 120.5);
  EXPECT_EQ(back.vehicle.size(), 2u);
  EXPECT_EQ(back.truth.at(0).targets.at(1).position.x(), 5.0);
  EXPECT_FALSE(first_difference(figures.tracks, tracks));
  EXPECT_EQ(figures.survey.channels.at("AUV1_GROUND_TRUTH"), 1);
  LogFigures of_another;
  EXPECT_THROW(read_log({path}, "", {}, of_another), core::InputError);
}

TEST(LogRecording, OfAFixedSensorHasNoVehicleStates) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.file("radar.lcmlog");
  core::Recording recording = example_recording();
  recording.is_fixed = true;
  write_log(path, recording, {}, "");
  LogFigures figures;
  EXPECT_TRUE(read_log({path}, "", {}, figures).is_fixed);
  EXPECT_FALSE(figures.survey.channels.contains("VEHICLE_STATE"));
}

TEST(LogRecording, RefusesTracksOfNoScan) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.file("dive.lcmlog");
  EXPECT_THROW(write_log(path, example_recording(), {{1'999'999, {}}}, ""), core::InputError);
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace lookout::tools
