#include "csht/joint/evidence/was_in_view.hpp"

#include <gtest/gtest.h>

#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

CloudMoments at(double north, double east, double north_velocity = 0.0) {
  CloudMoments moments;
  moments.mean << north, east, north_velocity, 0.0, 0.0, 0.0;
  return moments;
}

// Eleven scans in five seconds of a sonar at the origin that looks north, 150 m far and 45 degrees aside.
ScanHistory eleven_scans() {
  ScanHistory scans({}, {}, 11);
  for (int k = 0; k < 11; ++k) scans.push(posed_scan({}, 500'000L * k));
  return scans;
}

TEST(WasInView, KnowsRangeAndSectorWithATenthMore) {
  const ScanHistory scans = eleven_scans();
  EXPECT_TRUE(was_in_view(at(100.0, 50.0), scans, 10));
  EXPECT_TRUE(was_in_view(at(160.0, 0.0), scans, 10));
  EXPECT_FALSE(was_in_view(at(170.0, 0.0), scans, 10));
  EXPECT_TRUE(was_in_view(at(100.0, 105.0), scans, 10));   // 46 degrees.
  EXPECT_FALSE(was_in_view(at(100.0, 130.0), scans, 10));  // 52.
  EXPECT_FALSE(was_in_view(at(-60.0, 0.0), scans, 10));
}

// 175 m now, at 5 m/s: 150 m five seconds ago.
TEST(WasInView, RemembersOlderScans) {
  const ScanHistory scans = eleven_scans();
  EXPECT_TRUE(was_in_view(at(175.0, 0.0, 5.0), scans, 10));
  EXPECT_FALSE(was_in_view(at(175.0, 0.0, 5.0), scans, 2));
}

TEST(WasInView, ASonarThatDidNotPingLastCountsToo) {
  ScanHistory scans({}, {}, 2);
  scans.push(posed_scan({}, 0));
  scans.push(posed_scan({}, 250'000, {0.0, 0.0, core::radians(90.0)}));  // The other one looks east.
  EXPECT_TRUE(was_in_view(at(100.0, 0.0), scans, 1));
  EXPECT_FALSE(was_in_view(at(100.0, 0.0), scans, 0));
}

}  // namespace
}  // namespace lookout::csht
