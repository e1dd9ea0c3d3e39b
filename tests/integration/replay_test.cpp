// `lookout sim` into a log file (no network), and `lookout replay` of it.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tests {
namespace {

const std::string kScene = LOOKOUT_SOURCE_DIR "/tools/scenarios/turning_vehicle.yaml";
const std::string kTracker = " --tracker gnn --seed 1002 ";
const std::string kAsLive = " --unknown-sensor ";  // A log does not hold the scene's figures.

class ReplayTest : public ::testing::Test {
 protected:
  ReplayTest() {
    const auto result =
        run_lookout("sim " + kScene + " --speed max --seed 1002 --lcm-url 'file://" + log_ + "?mode=w'");
    EXPECT_EQ(result.status, 0) << result.err;
  }
  ProgramResult replay(const std::string& what, const std::string& out) const {
    return run_lookout("replay " + what + kTracker + "--out " + directory_.file(out));
  }
  std::string tracks(const std::string& out) const { return text_of(directory_.file(out) + "/tracks.csv"); }

  TemporaryDirectory directory_;
  std::string log_ = directory_.file("log.lcm");
};

TEST_F(ReplayTest, LogRecordingAndRunGiveTheSameTracksToTheByte) {
  ASSERT_EQ(run_lookout("run " + kScene + kTracker + kAsLive + "--out " + directory_.file("run")).status, 0);
  ASSERT_EQ(replay(log_, "a").status, 0);
  ASSERT_EQ(replay(log_, "b").status, 0);
  ASSERT_EQ(replay(directory_.file("run"), "c").status, 0);
  ASSERT_EQ(replay(directory_.file("a"), "d").status, 0);  // The log, unpacked.
  EXPECT_GT(tracks("a").size(), 1000u);
  EXPECT_EQ(tracks("a"), tracks("b"));
  EXPECT_EQ(tracks("a"), tracks("c"));
  EXPECT_EQ(tracks("a"), tracks("d"));
  EXPECT_EQ(tracks("a"), tracks("run"));
}

TEST_F(ReplayTest, DelayedTracksOfLogAndRunAreEqualAndOtherThanOnline) {
  const std::string joint = " --tracker joint --seed 1002 --out ";
  ASSERT_EQ(run_lookout("run " + kScene + kAsLive + "--lag 5" + joint + directory_.file("run")).status, 0);
  ASSERT_EQ(run_lookout("replay " + log_ + " --lag 5" + joint + directory_.file("a")).status, 0);
  ASSERT_EQ(run_lookout("replay " + log_ + joint + directory_.file("online")).status, 0);
  EXPECT_GT(tracks("a").size(), 1000u);
  EXPECT_EQ(tracks("a"), tracks("run"));
  EXPECT_NE(tracks("a"), tracks("online"));
  EXPECT_EQ(run_lookout("replay " + log_ + kTracker + "--lag 5 --out " + directory_.file("b")).status, 2);
}

TEST_F(ReplayTest, ALogThatIsCutOffGivesTheTracksUpToThereAndSaysSo) {
  ASSERT_EQ(replay(log_, "whole").status, 0);
  std::filesystem::resize_file(log_, std::filesystem::file_size(log_) / 2 + 13);
  const auto result = replay(log_, "half");
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("damaged or cut off"), std::string::npos) << result.err;
  EXPECT_GT(tracks("half").size(), 100u);
  EXPECT_TRUE(tracks("whole").starts_with(tracks("half")));
}

TEST_F(ReplayTest, GarbageInTheMiddleIsSteppedOver) {
  {
    std::fstream file(log_, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(std::filesystem::file_size(log_) / 2));
    file << std::string(500, 'x');
  }
  const auto result = replay(log_, "out");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("damaged or cut off"), std::string::npos) << result.err;
}

TEST_F(ReplayTest, BadInputIsStatusTwoAndOneLine) {
  const std::string nothing = directory_.write("nothing.lcm", "");
  const std::string out = " --out " + directory_.file("out");
  for (const std::string& arguments : {"replay /nowhere" + out, "replay " + nothing + out, "replay " + log_,
                                       "replay " + log_ + " --channel-prefix '.*'" + out}) {
    const auto result = run_lookout(arguments);
    EXPECT_EQ(result.status, 2) << arguments << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

TEST(LiveCommands, BadFlagsAreStatusTwo) {
  for (const std::string& arguments :
       {"sim " + kScene + " --speed fast --lcm-url memq://", "sim " + kScene + " --speed 0 --lcm-url memq://",
        std::string("sim /nowhere.yaml"), std::string("track --lcm-url http://x"),
        std::string("track --duration 0 --lcm-url memq://"),
        std::string("track --node-id 0 --lcm-url memq://"),
        std::string("score --channel-prefix '*' --lcm-url memq://"), std::string("score --truth all")}) {
    const auto result = run_lookout(arguments);
    EXPECT_EQ(result.status, 2) << arguments << "\n" << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

TEST(LiveCommands, StopByThemselvesAfterDurationOrSilence) {
  EXPECT_EQ(run_lookout("track --lcm-url memq:// --idle-exit 0.2").status, 0);
  EXPECT_EQ(run_lookout("score --lcm-url memq:// --duration 0.2").status, 0);
  EXPECT_EQ(run_lookout("sim " + kScene + " --lcm-url memq:// --wait-for 1 --duration 0.2").status, 0);
}

TEST(LiveCommands, FlushAndExitZeroOnSigterm) {
  const TemporaryDirectory directory;
  const auto result = run_lookout("track --lcm-url memq:// 2> " + directory.file("said") +
                                  " & pid=$!; sleep 0.5; kill -TERM $pid; wait $pid");
  EXPECT_EQ(result.status, 0) << result.err;
  const std::string said = text_of(directory.file("said"));
  EXPECT_NE(said.find("0 scans tracked"), std::string::npos) << said;
}

TEST(LiveCommands, TrackReadsALogThroughTheFileTransport) {
  const TemporaryDirectory directory;
  const std::string log = directory.file("log.lcm");
  ASSERT_EQ(run_lookout("sim " + kScene + " --speed max --lcm-url 'file://" + log + "?mode=w'").status, 0);
  const auto result = run_lookout("track --tracker gnn --lcm-url 'file://" + log + "?speed=0' --idle-exit 3");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find(" scans tracked; latency"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace lookout::tests
