// Sonar images on every road: run, a log, the recordings of both, imports.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/tools/import/oculus_bytes.hpp"

namespace lookout::tests {
namespace {

/// 90 beams about a degree apart.
std::string uneven_bearings() {
  std::ostringstream text;
  for (int beam = 0; beam < 90; ++beam) text << (beam == 0 ? "" : ", ") << beam - 44.5 + 0.3 * (beam % 3);
  return text.str();
}

/// 8 bits, uneven beams and gains, speckle that correlates, a vehicle that turns: little that a copy could
/// get right by chance.
std::string scene_text() {
  std::ostringstream text;
  text << "duration: 12.0\nvehicle: {north_velocity: 1.0, yaw_swing_deg: 6.0, yaw_period: 8.0}\n"
       << "sonar: {beam_bearings_deg: [" << uneven_bearings() << "], max_range: 150,\n"
       << "        scan_period: 0.5, miss_probability: 0.3, false_alarm_probability: 0.1}\n"
       << "image: {num_bins: 300, range_step: 0.5, beam_null_deg: 1.5, pulse_sigma: 0.55, snr_db: 20, bits: "
          "8,\n"
       << "        speckle: point_spread, gain_stripes: {depth_db: 1.0}}\n"
       << "targets: [{id: 1, north: 70.0, east: 3.0, north_velocity: 0.5, east_velocity: 0.3}]\n";
  return text.str();
}

class ImageReplayTest : public ::testing::Test {
 protected:
  ProgramResult run(const std::string& command, const std::string& out) const {
    return run_lookout(command + " --estimator h_pmht --seed 1002 --out " + directory_.file(out));
  }
  std::string tracks(const std::string& out) const { return text_of(directory_.file(out) + "/tracks.csv"); }

  TemporaryDirectory directory_;
  std::string scene_ = directory_.write("scene.yaml", scene_text());
};

TEST_F(ImageReplayTest, RunLogAndTheirRecordingsGiveTheSameTracksToTheByte) {
  const std::string log = directory_.file("log.lcm");
  ASSERT_EQ(
      run_lookout("sim " + scene_ + " --speed max --seed 1002 --lcm-url 'file://" + log + "?mode=w'").status,
      0);
  ASSERT_EQ(run("run " + scene_, "run").status, 0);
  ASSERT_EQ(run("replay " + directory_.file("run"), "again").status, 0);
  ASSERT_EQ(run("replay " + log, "log").status, 0);
  ASSERT_EQ(run("replay " + directory_.file("log"), "unpacked").status, 0);
  EXPECT_GT(tracks("run").size(), 1000u);
  for (const char* out : {"again", "log", "unpacked"}) EXPECT_EQ(tracks("run"), tracks(out)) << out;
  for (const char* file : {"/images.csv", "/bearings.csv", "/images/000023.pgm"})
    EXPECT_EQ(text_of(directory_.file("run") + file), text_of(directory_.file("log") + file)) << file;
}

TEST_F(ImageReplayTest, TbdTakesTheTimesOfARecording) {
  ASSERT_EQ(run("run " + scene_, "run").status, 0);
  const std::string out = directory_.file("tbd.csv");
  const auto result = run_lookout("tbd i_h_pmht_1 " + directory_.file("run") + " --out " + out);
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("24 frames"), std::string::npos) << result.err;
}

TEST_F(ImageReplayTest, WhatIsNotThereIsRefusedInOneLine) {
  std::filesystem::create_directory(directory_.file("none"));
  const std::string raw = directory_.write("a.raw", oculus_packet({}));
  ASSERT_EQ(run_lookout("import oculus " + raw + " --out " + directory_.file("oculus")).status, 0);
  const auto no_images = run("replay " + directory_.file("none"), "a");
  const auto no_scans = run_lookout("replay " + directory_.file("oculus") + " --out " + directory_.file("b"));
  EXPECT_NE(no_images.err.find("holds no images.csv"), std::string::npos) << no_images.err;
  EXPECT_NE(no_scans.err.find("holds images and no scans.csv"), std::string::npos) << no_scans.err;
  for (const auto& result : {no_images, no_scans}) {
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

}  // namespace
}  // namespace lookout::tests
