#include "csht/csht_params.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace lookout::csht {
namespace {

// 20 scans every half second span 9.5 s, half of it 4.75 s; sigma 3 m, steps .5 sigma and .7 sigma / 4.75 s.
TEST(CshtParams, TheGridFollowsTheSensorsAccuracy) {
  core::SonarParams sonar;
  sonar.range_sigma = 3.0;
  sonar.scan_period = 0.5;
  sonar.max_speed = 5.0;
  const HoughGrid grid = csht_grid(CshtParams::window(), sonar);
  EXPECT_DOUBLE_EQ(grid.intercept_step, 1.5);
  EXPECT_DOUBLE_EQ(grid.velocity_step, 0.7 * 3.0 / 4.75);
  EXPECT_DOUBLE_EQ(grid.max_speed, 5.0);
}

// A detection 150 m to either side, the fastest target and the fastest vehicle over half a window each way.
TEST(CshtParams, TheGridHoldsWhatTheSonarSees) {
  core::SonarParams sonar;
  sonar.max_range = 150.0;
  sonar.scan_period = 0.5;
  sonar.max_speed = 5.0;
  EXPECT_GE(csht_grid(CshtParams::window(), sonar).extent, 2.0 * (150.0 + 2.0 * 5.0 * 4.75));
}

TEST(CshtParams, AGridBeyondAllMemoryIsRefused) {
  core::SonarParams sonar;
  sonar.range_sigma = 0.005;
  EXPECT_THROW(csht_grid(CshtParams::tracking(), sonar), std::invalid_argument);
}

TEST(CshtParams, ALongerWindowHasFinerVelocities) {
  const core::SonarParams sonar;
  CshtParams params;
  const double short_step = csht_grid(params, sonar).velocity_step;
  params.window_scans = 39;  // 19 s, twice the duration
  EXPECT_NEAR(csht_grid(params, sonar).velocity_step, 0.5 * short_step, 1e-12);
}

// One degree over the root of 12 is 5.0 mrad: .76 m at 150 m, less than sigma; at 1500 m more.
TEST(CshtParams, TheLargestErrorIsThatOfRangeOrOfTheBearingFarOut) {
  core::SonarParams sonar;
  sonar.range_sigma = 3.0;
  sonar.bearing_step = std::numbers::pi / 180.0;
  sonar.max_range = 150.0;
  EXPECT_DOUBLE_EQ(largest_axis_sigma(sonar), 3.0);
  sonar.max_range = 1500.0;
  EXPECT_NEAR(largest_axis_sigma(sonar), 1500.0 * std::numbers::pi / 180.0 / std::sqrt(12.0), 1e-9);
}

// In a stream targets come and go: no share of the best one's support is asked, more evidence is, and the
// first detections, which leave the velocity open, meet a prior.
TEST(CshtParams, TheStreamAsksForEvidenceInPlaceOfPresence) {
  const CshtParams window = CshtParams::window(), stream = CshtParams::tracking();
  EXPECT_GT(window.decision.relative_support, 0.0);
  EXPECT_EQ(stream.decision.relative_support, 0.0);
  EXPECT_GT(stream.decision.min_evidence, window.decision.min_evidence);
  EXPECT_EQ(window.speed_prior, 0.0);
  EXPECT_GT(stream.speed_prior, 0.0);
}

}  // namespace
}  // namespace lookout::csht
