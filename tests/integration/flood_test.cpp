// Sonars that report more than one return a beam, up to floods of them, and logs on a full disk.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/files/grey_image.hpp"
#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tests {
namespace {

const std::string kScenes = LOOKOUT_SOURCE_DIR "/tools/scenarios/";
constexpr double kNobodyFollowed = 20.0;  // OSPA [m]: the cut-off.

class Flood : public ::testing::Test {
 protected:
  /// A scene of `tools/scenarios`, cut to so many seconds.
  nlohmann::json run(const std::string& scene, int seconds) {
    std::string text = text_of(kScenes + scene);
    const auto at = text.find("duration: ");
    text.replace(at, text.find('\n', at) - at, "duration: " + std::to_string(seconds));
    const auto result =
        run_lookout("run " + folder_.write("scene.yaml", text) + " --seed 1 --out " + folder_.file("out"));
    EXPECT_EQ(result.status, 0) << result.err;
    said_ = result.err;
    return nlohmann::json::parse(text_of(folder_.file("out/summary.json")));
  }
  static double ospa(const nlohmann::json& summary) { return summary["ospa"]["total"]; }

  TemporaryDirectory folder_;
  std::string said_;
};

// Its targets were hidden behind the ring-down: 20 m. Without it, sea_uniform.yaml, they are at 2 m; 3.9 m
// came out.
TEST_F(Flood, ARingDownHidesNothingAndIsCounted) {
  const auto summary = run("sea_several_returns.yaml", 80);
  EXPECT_LT(ospa(summary), 0.3 * kNobodyFollowed);
  EXPECT_GT(summary["received"]["returns_ringing"], 155 * 75);  // Of 160 scans, at .95 in 90 beams.
  EXPECT_NE(said_.find("returns are the transducer's ring-down and left out"), std::string::npos);
}

// Two returns in each of ninety beams at each scan.
TEST_F(Flood, AllReturnsOfABeamCount) {
  const auto summary = run("sensor_echoes.yaml", 20);
  EXPECT_LT(ospa(summary), 0.5 * kNobodyFollowed);
  EXPECT_GT(summary["received"]["returns_behind"], 40 * 80);
  EXPECT_NE(said_.find("beams report several returns: all of them count"), std::string::npos);
}

// 2,700 returns a scan: what was left out is known, and no returns are lost otherwise.
TEST_F(Flood, WhatIsLeftOutOfACrowdedScanIsCounted) {
  const auto summary = run("sensor_flood.yaml", 10);
  const auto& received = summary["received"];
  EXPECT_EQ(received["scans"], received["tracked"]);
  EXPECT_EQ(received["returns"].get<int>() - received["returns_shed"].get<int>(),
            512 * received["tracked"].get<int>());
}

/// The limit of a file's size, 4 kB, stands in for a full disk.
class FullDisk : public ::testing::Test {
 protected:
  /// Runs the program and asks for status 1 and these words.
  void expect_refusal(const std::string& arguments, const std::string& what) const {
    const std::string program = std::string(LOOKOUT_PROGRAM) + " " + arguments;
    const int status =
        std::system(("trap '' XFSZ; ulimit -f 8; exec " + program + " 2> " + folder_.file("said")).c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1) << arguments;
    const std::string said = text_of(folder_.file("said"));
    EXPECT_NE(said.find(what), std::string::npos) << said;
  }

  TemporaryDirectory folder_;
};

// LCM tells of neither.
TEST_F(FullDisk, UnderALogIsStatusOneAndALine) {
  expect_refusal(
      "sim " + kScenes + "crossing.yaml --speed max --lcm-url 'file://" + folder_.file("log") + "?mode=w'",
      "bytes could be written: is the disk full?");
}

// A picture that could not be written was once left out, like one that cannot be read, with status 0.
TEST_F(FullDisk, UnderPicturesIsStatusOneAndALineAndLeavesNoPart) {
  for (int k = 1; k <= 3; ++k)
    core::write_pgm(folder_.file("picture" + std::to_string(k) + ".pgm"),
                    {60, 60, std::vector<double>(3600, 1.0)});
  const std::string geometry = folder_.write(
      "geometry.yaml",
      "num_beams: 60\nfirst_bearing_deg: -59\nbearing_step_deg: 2\nrange_step: 1\nping_period: 1\n");
  expect_refusal("import pgm " + folder_.path() + " " + geometry + " --out " + folder_.file("out"),
                 "000000.pgm: could not be written completely");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.file("out/images")));
}

TEST_F(FullDisk, UnderResultsIsStatusOneAndALine) {
  const std::string out = " --out " + folder_.file("out");
  expect_refusal("replay " LOOKOUT_SOURCE_DIR "/tests/data/cases/range_switched.lcmlog --tracker gnn" + out,
                 "could not be written completely");
  expect_refusal("experiment csht-window --runs 1 --jobs 1 --only method=sht" + out,
                 "runs.jsonl: could not be written");
}

}  // namespace
}  // namespace lookout::tests
