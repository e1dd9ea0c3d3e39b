// `lookout run` on scenes of a real sea: what it writes, and that a recording of it replays.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/integration/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tests {
namespace {

const std::string kScenarios = LOOKOUT_SOURCE_DIR "/tools/scenarios/";
const std::string kTracker = " --tracker gnn --seed 1003 ";

class SeaTest : public ::testing::Test {
 protected:
  void run(const std::string& scene) const {
    const auto result =
        run_lookout("run " + kScenarios + scene + kTracker + "--out " + directory_.file("run"));
    ASSERT_EQ(result.status, 0) << result.err;
  }
  std::string tracks(const std::string& out) const { return text_of(directory_.file(out) + "/tracks.csv"); }

  TemporaryDirectory directory_;
};

TEST_F(SeaTest, ARunWithLostScansReplaysToTheByte) {
  run("sea_lost_scans.yaml");
  ASSERT_EQ(
      run_lookout("replay " + directory_.file("run") + kTracker + "--out " + directory_.file("again")).status,
      0);
  EXPECT_GT(tracks("run").size(), 1000u);
  EXPECT_EQ(tracks("run"), tracks("again"));
}

TEST_F(SeaTest, EachSonarOfAVehicleHasItsOwnDirectory) {
  run("sea_two_sonars.yaml");
  EXPECT_GT(tracks("run/sonar1").size(), 1000u);
  EXPECT_GT(tracks("run/sonar2").size(), 1000u);
  EXPECT_NE(text_of(directory_.file("run/sonar1/sonar.yaml")).find("num_beams: 90\n"), std::string::npos);
  EXPECT_NE(text_of(directory_.file("run/sonar2/sonar.yaml")).find("num_beams: 120\n"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(directory_.file("run/scans.csv")));
}

}  // namespace
}  // namespace lookout::tests
