// Sonars that report more than one return a beam, up to floods of them, and logs on a full disk.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

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

// Its targets were hidden behind the ring-down: 20 m. Without it, sea_uniform.yaml, they are at 2 m; 3.9 m came out.
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

// The limit of a file's size stands in for a full disk; LCM tells of neither.
TEST(FullDisk, UnderALogIsStatusOneAndALine) {
  const TemporaryDirectory folder;
  const std::string sim = std::string(LOOKOUT_PROGRAM) + " sim " + kScenes + "crossing.yaml --speed max";
  const std::string log = " --lcm-url 'file://" + folder.file("log") + "?mode=w'";
  const std::string limited = "trap '' XFSZ; ulimit -f 8; exec " + sim + log + " 2> " + folder.file("said");
  const int status = std::system(limited.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_NE(text_of(folder.file("said")).find("bytes could be written: is the disk full?"),
            std::string::npos);
}

}  // namespace
}  // namespace lookout::tests
