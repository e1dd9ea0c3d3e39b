#include "csht/joint/density/sensor_scale.hpp"

#include <gtest/gtest.h>

namespace lookout::csht {
namespace {

TEST(SensorScale, TheReferenceSonarChangesNothing) {
  const JointEngineParams before;
  const JointEngineParams after = scaled(before, SensorScale::of({}));
  EXPECT_EQ(after.cloud.memory_s, before.cloud.memory_s);
  EXPECT_EQ(after.cloud.position_floor, before.cloud.position_floor);
  EXPECT_EQ(after.cloud.turn_prior, before.cloud.turn_prior);
  EXPECT_EQ(after.birth.window_s, before.birth.window_s);
  EXPECT_EQ(after.birth.max_lag_s, before.birth.max_lag_s);
  EXPECT_EQ(after.birth.first_look_s, before.birth.first_look_s);
  EXPECT_EQ(after.prior.settling_rate, before.prior.settling_rate);
}

// A radar that turns once in 20 s: lags of ten seconds would never pair two of its scans.
TEST(SensorScale, SlowScansStretchTheTimes) {
  core::SonarParams slow;
  slow.scan_period = 20.0;
  const JointEngineParams after = scaled({}, SensorScale::of(slow));
  EXPECT_DOUBLE_EQ(after.birth.max_lag_s, 100.0);  // Five scans,
  EXPECT_DOUBLE_EQ(after.birth.window_s, 160.0);   // eight,
  EXPECT_DOUBLE_EQ(after.cloud.memory_s, 480.0);   // twenty-four.
}

// 0.1 m where the reference has 3 m; half of 40 m times the error of half-degree beams is smaller.
TEST(SensorScale, AFineSonarHasShortLengths) {
  core::SonarParams fine;
  fine.range_sigma = 0.1;
  fine.bearing_step = core::radians(0.5);
  fine.max_range = 40.0;
  fine.scan_period = 0.1;
  const SensorScale scale = SensorScale::of(fine);
  EXPECT_NEAR(scale.length, 1.0 / 30.0, 1e-12);
  EXPECT_NEAR(scaled({}, scale).birth.track_reach, 1.0, 1e-12);
  EXPECT_NEAR(scaled({}, scale).birth.max_lag_s, 0.5, 1e-12);  // Five scans: ten times 1/30 s is less.
}

TEST(SensorScale, FarBearingsSetTheLengthOfARadar) {
  core::SonarParams radar;
  radar.max_range = 3000.0;
  radar.bearing_sigma = 0.01;
  EXPECT_NEAR(SensorScale::of(radar).length, 5.0, 1e-12);  // 15 m across.
}

}  // namespace
}  // namespace lookout::csht
