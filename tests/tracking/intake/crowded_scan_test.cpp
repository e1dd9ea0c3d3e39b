#include "tracking/intake/crowded_scan.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// Three beams of .1 rad about the axis.
core::SonarScan scan_of(std::vector<core::SonarReturn> returns) {
  core::SonarScan scan;
  scan.first_bearing = -0.1;
  scan.bearing_step = 0.1;
  scan.max_range = 100.0;
  scan.num_beams = 3;
  scan.returns = std::move(returns);
  return scan;
}

TEST(CrowdedScan, KeepsAllOfAScanThatIsNotCrowded) {
  auto scan = scan_of({{0.0, 5.0}, {0.0, 6.0}});
  EXPECT_EQ(thin_out(scan, 2), 0);
  EXPECT_EQ(scan.returns.size(), 2u);
}

// Each beam gives one before any gives a second: its strongest, of equals its nearest.
TEST(CrowdedScan, TakesFromBeamsInTurns) {
  auto scan =
      scan_of({{0.0, 9.0, 1.0}, {0.0, 5.0, 1.0}, {0.0, 7.0, 3.0}, {0.1, 40.0, 1.0}, {-0.1, 60.0, 1.0}});
  EXPECT_EQ(thin_out(scan, 4), 1);
  ASSERT_EQ(scan.returns.size(), 4u);
  EXPECT_EQ(scan.returns[0].range, 5.0);
  EXPECT_EQ(scan.returns[1].range, 7.0);
  EXPECT_EQ(scan.returns[2].range, 40.0);
  EXPECT_EQ(thin_out(scan, 3), 1);
  EXPECT_EQ(scan.returns[0].range, 7.0);
}

// 512 at two scans a second; of a minute at 20 Hz a third of a thousand fits.
TEST(CrowdedScan, TakesFewerOfAFastSensor) {
  EXPECT_EQ(most_returns(0.5), 512u);
  EXPECT_EQ(most_returns(0.05), 333u);
  EXPECT_EQ(most_returns(0.001), 256u);
}

TEST(CrowdedScan, CountsReturnsBehindOthersOfTheirBeam) {
  std::vector<char> heard;
  EXPECT_EQ(returns_behind(scan_of({{0.0, 5.0}, {0.1, 6.0}}), heard), 0);
  EXPECT_EQ(returns_behind(scan_of({{0.0, 5.0}, {0.0, 6.0}, {0.01, 7.0}}), heard), 2);
}

}  // namespace
}  // namespace lookout::tracking
