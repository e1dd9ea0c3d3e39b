#include "tracking/intake/ring_down.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/sonar_params.hpp"

namespace lookout::tracking {
namespace {

constexpr double kSharp = 0.5;

core::SonarScan empty_scan() {
  const core::SonarParams sonar;
  core::SonarScan scan;
  scan.first_bearing = sonar.first_bearing;
  scan.bearing_step = sonar.bearing_step;
  scan.max_range = sonar.max_range;
  scan.num_beams = sonar.num_beams;
  return scan;
}

/// A return at `range` in so many beams of 90, and echoes of targets at 50 m in three of them.
core::SonarScan ringing_scan(int beams, double range, bool targets) {
  core::SonarScan scan = empty_scan();
  for (int beam = 0; beam < beams; ++beam)
    scan.returns.push_back({scan.first_bearing + beam * scan.bearing_step, range});
  for (int beam = 10; targets && beam < 13; ++beam)
    scan.returns.push_back({scan.first_bearing + beam * scan.bearing_step, 50.0});
  return scan;
}

std::int64_t left_out_of(RingDown& ring, const core::SonarScan& scan, int scans) {
  std::int64_t left_out = 0;
  for (int k = 0; k < scans; ++k) {
    core::SonarScan next = scan;
    left_out = ring.drop(next, kSharp);
  }
  return left_out;
}

TEST(RingDown, IsLeftOutFromTheFifthScanOn) {
  RingDown ring;
  EXPECT_EQ(left_out_of(ring, ringing_scan(63, 1.0, true), 4), 0);
  auto fifth = ringing_scan(63, 1.0, true);
  EXPECT_EQ(ring.drop(fifth, kSharp), 63);
  ASSERT_EQ(fifth.returns.size(), 3u);
  EXPECT_EQ(fifth.returns[0].range, 50.0);
}

// A beam that rings and reports one return has heard nothing else; what is far is no transducer; a few beams
// are none.
TEST(RingDown, IsNeitherASonarOfOneReturnABeamNorABottomNorAFewBeams) {
  RingDown single, far, few;
  EXPECT_EQ(left_out_of(single, ringing_scan(90, 1.0, false), 9), 0);
  EXPECT_EQ(left_out_of(far, ringing_scan(90, 20.0, true), 9), 0);
  EXPECT_EQ(left_out_of(few, ringing_scan(40, 1.0, true), 9), 0);
}

// Of thirty returns a beam the nearest of each lies near as well.
TEST(RingDown, IsNotTheNearSideOfDenseClutter) {
  RingDown ring;
  core::Random random(3);
  for (int k = 0; k < 9; ++k) {
    core::SonarScan scan = empty_scan();
    for (int beam = 0; beam < 90; ++beam)
      for (int i = 0; i < 30; ++i)
        scan.returns.push_back({scan.first_bearing + beam * scan.bearing_step, random.uniform(0.0, 150.0)});
    EXPECT_EQ(ring.drop(scan, 3.0), 0);
  }
}

}  // namespace
}  // namespace lookout::tracking
