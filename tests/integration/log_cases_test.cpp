// Logs as people's sensors and loggers make them: what each gives, from the log and from the recording that
// replay unpacks. The figures of a case are those of its making: targets, scans, returns.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <vector>

#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tests {
namespace {

std::string case_file(const std::string& name) {
  return LOOKOUT_SOURCE_DIR "/tests/data/cases/" + name + ".lcmlog";
}

class LogCases : public ::testing::Test {
 protected:
  ProgramResult replay(const std::string& input, const std::string& out,
                       const std::string& flags = "") const {
    return run_lookout("replay " + input + " --out " + directory_.file(out) + flags);
  }
  std::string tracks(const std::string& out) const { return text_of(directory_.file(out) + "/tracks.csv"); }

  /// Rows of each confirmed or coasting identity.
  std::map<int, int> lives(const std::string& out) const {
    std::map<int, int> rows;
    std::istringstream text(tracks(out));
    std::string line;
    std::getline(text, line);
    while (std::getline(text, line)) {
      const std::size_t id = line.find(',') + 1;
      if (line.find(",tentative,") == std::string::npos) ++rows[std::stoi(line.substr(id))];
    }
    return rows;
  }
  /// Identities that live for at least `scans`.
  int long_lives(const std::string& out, int scans) const {
    const auto all = lives(out);
    return static_cast<int>(
        std::count_if(all.begin(), all.end(), [=](const auto& life) { return life.second >= scans; }));
  }
  /// Distance of the farthest confirmed or coasting track from the origin [m].
  double farthest(const std::string& out) const {
    double most = 0.0;
    std::istringstream text(tracks(out));
    std::string time, id, status, north, east, rest;
    std::getline(text, rest);
    while (std::getline(text, time, ',') && std::getline(text, id, ',') && std::getline(text, status, ',') &&
           std::getline(text, north, ',') && std::getline(text, east, ',') && std::getline(text, rest))
      if (status != "tentative") most = std::max(most, std::hypot(std::stod(north), std::stod(east)));
    return most;
  }
  /// The log and the recording that is unpacked from it give the same tracks to the byte.
  void expect_same_from_recording(const std::string& name) const {
    ASSERT_EQ(replay(case_file(name), "log").status, 0);
    const auto again = replay(directory_.file("log"), "again");
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_GT(tracks("log").size(), 1000u);
    EXPECT_EQ(tracks("log"), tracks("again"));
  }
  static void expect_said(const ProgramResult& result, const std::string& what) {
    EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
  }

  TemporaryDirectory directory_;
};

TEST_F(LogCases, SilentBeamsAreSilencesAndCounted) {
  for (const char* name : {"silent_beams_inf", "silent_beams_nan"}) {
    const auto result = replay(case_file(name), name);
    EXPECT_EQ(result.status, 0) << result.err;
    expect_said(result, "60 scans tracked");
    expect_said(result, "returns of inf, NaN or 0 taken as silences");
    EXPECT_EQ(long_lives(name, 40), 2);
  }
  EXPECT_EQ(tracks("silent_beams_inf"), tracks("silent_beams_nan"));
}

TEST_F(LogCases, BeamsFromStarboardToPortAreServed) {
  const auto result = replay(case_file("negative_bearing_step"), "log");
  EXPECT_EQ(result.status, 0) << result.err;
  expect_said(result, "60 scans tracked\n");
  EXPECT_EQ(long_lives("log", 40), 2);
  expect_same_from_recording("negative_bearing_step");
}

TEST_F(LogCases, ARecordingKeepsTheRangeAndTheFanByTime) {
  for (const char* name : {"range_switched", "fan_switched"}) {
    expect_same_from_recording(name);
    EXPECT_TRUE(std::filesystem::exists(directory_.file("log") + "/geometry.csv"));
    EXPECT_EQ(long_lives("again", 30), 3) << name;
  }
}

TEST_F(LogCases, ALogPlayedTwiceIsTrackedTwiceWithNewIdentities) {
  const auto result = replay(case_file("log_played_twice"), "log");
  EXPECT_EQ(result.status, 0) << result.err;
  expect_said(result, "80 scans tracked, 1 new clocks\n");
  expect_said(result, "holds 2 clocks");
  EXPECT_EQ(long_lives("log", 25), 4);  // Two targets, twice: no identity is used again.
  expect_same_from_recording("log_played_twice");
}

TEST_F(LogCases, AnAppendedLogWhoseSequenceRestartsGivesTheSameFromItsRecording) {
  expect_same_from_recording("log_appended_sequence_restarts");
  EXPECT_GE(long_lives("log", 30), 2);
}

TEST_F(LogCases, AClockThatIsSetBackLosesNoScanAndNoIdentity) {
  const auto result = replay(case_file("clock_steps_back_3s"), "log");
  EXPECT_EQ(result.status, 0) << result.err;
  expect_said(result, "60 scans tracked, 1 new clocks\n");
  expect_said(result, "the clock was set back by 3");
  EXPECT_EQ(long_lives("log", 40), 2);  // Two targets: the numbers go on, so that they are the same ones.
  expect_same_from_recording("clock_steps_back_3s");
}

TEST_F(LogCases, TwoSonarsLoseNoScanAndNoCount) {
  for (const char* name : {"two_sonars_at_one_time", "two_sonars_in_turn"}) {
    const auto result = replay(case_file(name), "log");
    EXPECT_EQ(result.status, 0) << result.err;
    expect_said(result, "120 scans tracked\n");
    expect_same_from_recording(name);
    EXPECT_EQ(long_lives("log", 100), 2) << name;  // Two targets.
    // Sonars of 100 m on a vehicle that goes 60 m from the origin. A track once began 860 m away, behind it.
    EXPECT_LT(farthest("log"), 180.0) << name;
  }
}

// The newest scan is often the other sonar's: a young track that was drawn anew there went 280 km away.
TEST_F(LogCases, NoTrackOfTwoSonarsIsFlungOutOfTheirView) {
  const std::string log = directory_.file("two.lcmlog");
  const auto sent =
      run_lookout("sim " LOOKOUT_SOURCE_DIR
                  "/tools/scenarios/sea_two_sonars.yaml --seed 1011 --speed 1000 --lcm-url 'file://" +
                  log + "?mode=w'");
  ASSERT_EQ(sent.status, 0) << sent.err;
  const auto result = replay(log, "log");
  EXPECT_EQ(result.status, 0) << result.err;
  expect_said(result, "320 scans tracked");
  EXPECT_LT(farthest("log"), 260.0);  // 150 m in view of a vehicle that goes 66 m from where it set out.
}

TEST_F(LogCases, DamagedLengthsCostTheirEventsAlone) {
  const auto result = replay(case_file("log_lengths_damaged"), "log");
  EXPECT_EQ(result.status, 0) << result.err;
  expect_said(result, "47 messages");  // Those that are whole, and of them
  expect_said(result, "15 scans tracked");
  expect_said(result, "place(s) could not be read");
}

// Two targets over 60 scans, each under one identity: as even beams, one of them was lost and found three
// times.
TEST_F(LogCases, BeamsThatAreEvenInSineAreFoundAndTakenAtTheirBearings) {
  const auto result = replay(case_file("uneven_beams"), "log");
  EXPECT_EQ(result.status, 0) << result.err;
  expect_said(result, "60 scans tracked\n");
  expect_said(result, "beams are even in sine");
  EXPECT_EQ(long_lives("log", 55), 2);
  EXPECT_EQ(lives("log").size(), 2u);
  expect_same_from_recording("uneven_beams");
}

// The same beams as a table: nothing is left to be found, and the recording keeps it.
TEST_F(LogCases, ATableOfUnevenBeamsHoldsFromTheFirstScanAndInTheRecording) {
  constexpr double kOuter = 1.0471975511965976;  // [rad]
  std::string table = "sensor: {beam_bearings_deg: [";
  for (int beam = 0; beam < 128; ++beam) {
    const double bearing = std::asin(std::sin(kOuter) * (2.0 * beam / 127.0 - 1.0));
    table += (beam > 0 ? ", " : "") + std::to_string(bearing * 180.0 / std::numbers::pi);
  }
  const auto result =
      replay(case_file("uneven_beams"), "log", " --config " + directory_.write("beams.yaml", table + "]}\n"));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err.find("even in sine"), std::string::npos) << result.err;
  EXPECT_EQ(long_lives("log", 55), 2);
  ASSERT_EQ(replay(directory_.file("log"), "again").status, 0);
  EXPECT_EQ(tracks("log"), tracks("again"));
}

TEST_F(LogCases, WhatRefusesALogSaysWhy) {
  const std::string log = case_file("range_switched");
  const auto line_of = [this](const std::string& arguments) {
    const auto result = run_lookout("replay " + arguments + " --out " + directory_.file("out"));
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  };
  EXPECT_NE(line_of(log + " --channel-prefix AUV1_")
                .find("holds no AUV1_SONAR_SCAN; its channels: SONAR_SCAN (80), VEHICLE_STATE (80)"),
            std::string::npos);
  EXPECT_NE(line_of(directory_.write("empty", "")).find("is empty"), std::string::npos);
  EXPECT_NE(line_of(directory_.write("text", "time_s,bearing_rad\n")).find("is text, no LCM log"),
            std::string::npos);
  EXPECT_NE(line_of(directory_.write("foreign", "\x89PNG\r\n\x1a\n")).find("is no LCM log"),
            std::string::npos);
}

TEST_F(LogCases, ARecordingWithoutVehicleIsAFixedSensorAtTheOrigin) {
  ASSERT_EQ(replay(case_file("negative_bearing_step"), "log").status, 0);
  std::filesystem::remove(directory_.file("log") + "/vehicle.csv");
  const auto result = replay(directory_.file("log"), "fixed");
  EXPECT_EQ(result.status, 0) << result.err;
  expect_said(result, "no vehicle.csv: a fixed sensor at the origin");
  expect_said(result, "60 scans tracked\n");
}

TEST_F(LogCases, SparseNavigationNamesItsLimitWhichCanBeSet) {
  ASSERT_EQ(replay(case_file("negative_bearing_step"), "log").status, 0);
  std::string sparse = "time_s,north_m,east_m,heading_rad\n";
  for (int second = 0; second <= 60; second += 20) sparse += std::to_string(second) + ",0,0,0\n";
  std::filesystem::remove(directory_.file("log") + "/vehicle.csv");
  directory_.write("log/vehicle.csv", sparse);
  const auto refused = replay(directory_.file("log"), "refused");
  expect_said(refused, "max_pose_gap_s (2 s)");
  const std::string config = directory_.write("config.yaml", "sensor: {max_pose_gap_s: 20}\n");
  expect_said(replay(directory_.file("log"), "taken", " --config " + config), "60 scans tracked\n");
}

}  // namespace
}  // namespace lookout::tests
