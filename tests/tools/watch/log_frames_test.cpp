#include "tools/watch/log_frames.hpp"

#include <gtest/gtest.h>

#include <lcm/lcm-cpp.hpp>
#include <nlohmann/json.hpp>

#include "core/input_error.hpp"
#include "tests/support/log_message.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/tools/watch/watch_examples.hpp"

namespace lookout::tools {
namespace {

/// Scans half a second apart with states on both sides and a track that goes north a metre each.
std::string write_log(const std::string& path, int scans, bool with_tracks) {
  lcm::LogFile file(path, "w");
  for (int k = 0; k < scans; ++k) {
    core::SonarScan scan = tests::example_scan();
    scan.utime = 500'000 * k;
    scan.sequence = k;
    core::Track track = tests::example_track(7);
    track.state[0] = k;
    tests::log_message(file, "VEHICLE_STATE",
                       lcmtypes::to_wire(core::VehicleState{scan.utime - 10'000, {1.0, 2.0, 0.0}, {0, 0}}));
    tests::log_message(file, "SONAR_SCAN", lcmtypes::to_wire(scan));
    tests::log_message(file, "VEHICLE_STATE",
                       lcmtypes::to_wire(core::VehicleState{scan.utime + 10'000, {1.0, 2.0, 0.0}, {0, 0}}));
    if (with_tracks)
      tests::log_message(file, "TRACKS", lcmtypes::to_wire({scan.utime, k, 0}, std::span(&track, 1)).message);
  }
  return path;
}

TEST(LogFrames, GivesAnyFrameInAnyOrder) {
  const tests::TemporaryDirectory directory;
  const LogFrames frames(write_log(directory.file("log"), 100, true), "");
  ASSERT_EQ(frames.size(), 100u);
  for (const std::size_t n : {99u, 0u, 50u}) {
    const auto frame = frames.frame(n);
    EXPECT_EQ(frame["tracks"]["tracks"][0]["north"], static_cast<double>(n));
    EXPECT_EQ(frame["scan"]["sequence"], n);
    EXPECT_FALSE(frame["scan"]["pose"].is_null());
    EXPECT_TRUE(frame["ospa"].is_null());
  }
}

TEST(LogFrames, GivesTheTrailsBeforeAFrame) {
  const tests::TemporaryDirectory directory;
  const LogFrames frames(write_log(directory.file("log"), 100, true), "");
  const auto trail = frames.trails(99)["7"];
  EXPECT_EQ(trail.size(), 61u);  // 30 s at 2 Hz, both ends.
  EXPECT_EQ(trail.back()[1], 99.0);
  EXPECT_EQ(frames.trails(2)["7"].size(), 3u);
}

TEST(LogFrames, TakesScansWhereNobodyTracked) {
  const tests::TemporaryDirectory directory;
  const LogFrames frames(write_log(directory.file("log"), 10, false), "");
  ASSERT_EQ(frames.size(), 10u);
  EXPECT_EQ(frames.frame(4)["scan"]["sequence"], 4);
  EXPECT_EQ(frames.trails(4).size(), 0u);
}

TEST(LogFrames, HandsDecisionsOnAndCountsWhatIsDamagedOnAnyChannel) {
  const tests::TemporaryDirectory directory;
  const std::string path = write_log(directory.file("log"), 3, true);
  {
    lcm::LogFile file(path, "a");
    const auto decisions = lcmtypes::to_wire(lcmtypes::DecisionReport{5, 6, 7, "1 s track 3: confirmed\n"});
    tests::log_message(file, "DECISIONS", decisions);
    tests::log_message(file, "DECISIONS", lcmtypes::to_wire(tests::example_state()));
    tests::log_message(file, "SONAR_SCAN", decisions);
    tests::log_message(file, "OSPA", decisions);
    tests::log_message(file, "TRACKS", decisions);  // No frame of its own.
  }
  std::string told;
  const LogFrames frames(path, "", [&](const lcmtypes::DecisionReport& report) { told += report.text; });
  EXPECT_EQ(told, "1 s track 3: confirmed\n");
  EXPECT_EQ(frames.size(), 3u);
  ASSERT_EQ(frames.refusals().size(), 4u);
  for (const auto& refusal : frames.refusals()) {
    EXPECT_EQ(refusal.count, 1) << refusal.channel;
    EXPECT_EQ(refusal.reason, "not one whole message of its type");
  }
}

TEST(LogFrames, RefusesWhatIsNoLogOfOurs) {
  const tests::TemporaryDirectory directory;
  const std::string path = write_log(directory.file("log"), 3, true);
  EXPECT_NE(testing::error_of([&] { LogFrames(path, "AUV1_"); }).find("with the prefix AUV1_"),
            std::string::npos);
  EXPECT_THROW(LogFrames(directory.write("text", "no log"), ""), core::InputError);
  EXPECT_THROW(LogFrames("/no/such/file", ""), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
