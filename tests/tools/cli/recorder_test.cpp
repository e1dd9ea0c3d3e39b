#include "tools/cli/recorder.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

core::SonarScan scan_at(std::int64_t utime, std::int64_t sequence) {
  const core::SonarParams params;
  core::SonarScan scan;
  scan.utime = utime;
  scan.sequence = sequence;
  scan.first_bearing = params.first_bearing;
  scan.bearing_step = params.bearing_step;
  scan.max_range = params.max_range;
  scan.num_beams = params.num_beams;
  return scan;
}

core::VehicleState state_at(std::int64_t utime, double north) {
  return {utime, {north, 0.0, 0.0}, {0.0, 0.0}};
}

TEST(Recorder, KeepsWhatIsBelieved) {
  Recorder recorder{core::SonarParams()};
  for (int i = 0; i < 3; ++i) {
    recorder.add(state_at(i * kSecond, i));
    recorder.add(scan_at(i * kSecond, i));
    recorder.add(scan_at(i * kSecond, i));  // Twice.
    recorder.add(core::GroundTruth{i * kSecond, {}});
  }
  const core::Recording recording = recorder.finish();
  EXPECT_EQ(recording.scans.size(), 3u);
  EXPECT_EQ(recording.vehicle.size(), 3u);
  EXPECT_EQ(recording.truth.size(), 3u);
  EXPECT_TRUE(recording.new_clocks.empty());
}

TEST(Recorder, BeginsAClockWithItsStatesAndItsTruth) {
  Recorder recorder{core::SonarParams()};
  for (int i = 0; i < 40; ++i) {
    const std::int64_t utime = i % 20 * kSecond;
    recorder.add(state_at(utime, i));
    recorder.add(core::GroundTruth{utime, {}});
    recorder.add(scan_at(utime, i));
  }
  const core::Recording recording = recorder.finish();
  ASSERT_EQ(recording.new_clocks.size(), 1u);
  EXPECT_EQ(recording.new_clocks[0].scan, 20u);
  EXPECT_EQ(recording.new_clocks[0].state, 20u);
  EXPECT_EQ(recording.new_clocks[0].truth, 20u);
  EXPECT_EQ(recording.scans.size(), 40u);
}

TEST(Recorder, KeepsThePoseThatAScanHadThoughAnotherStateCameAfterIt) {
  Recorder recorder{core::SonarParams()};
  recorder.add(state_at(0, 0.0));
  recorder.add(scan_at(kSecond / 2, 0));
  recorder.add(state_at(kSecond, 1.0));           // The scan goes at 0.5 m.
  recorder.add(state_at(3 * kSecond / 4, 10.0));  // Late, and beside the line.
  const core::Recording recording = recorder.finish();
  ASSERT_EQ(recording.vehicle.size(), 4u);
  EXPECT_EQ(recording.vehicle[1].utime, kSecond / 2);
  EXPECT_NEAR(recording.vehicle[1].T_earth_body.north, 0.5, 1e-9);
}

}  // namespace
}  // namespace lookout::tools
