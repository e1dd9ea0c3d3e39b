#include "tracking/baselines/kalman_tracker.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/patch_sea.hpp"
#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

TEST(KalmanTracker, LearnsWhereFalseReturnsAreDense) {
  expect_map_finds_patch<KalmanTracker, KalmanParams>();
}

TEST(KalmanTracker, ConfirmsOnTheMthDetectionAndFollows) {
  KalmanTracker tracker({}, {});
  for (int k = 0; k < 3; ++k)
    ASSERT_EQ(tracker.update(scan_of(k, {{50.0 + 0.5 * k, 0.0}}), {})[0].status,
              core::TrackStatus::tentative);
  std::span<const core::Track> tracks = tracker.update(scan_of(3, {{51.5, 0.0}}), {});
  EXPECT_EQ(tracks[0].status, core::TrackStatus::confirmed);  // 4 of 8
  for (int k = 4; k < 40; ++k) tracks = tracker.update(scan_of(k, {{50.0 + 0.5 * k, 0.0}}), {});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_NEAR(tracks[0].state(0), 69.5, 0.1);
}

TEST(KalmanTracker, DropsATrackThatIsSilentForLong) {
  KalmanTracker tracker({}, {});
  for (int k = 0; k < 40; ++k) tracker.update(scan_of(k, {{50.0 + 0.5 * k, 0.0}}), {});
  std::span<const core::Track> tracks;
  for (int k = 40; k < 46; ++k) tracks = tracker.update(scan_of(k, {}), {});
  EXPECT_EQ(tracks.size(), 1U);  // six misses are allowed
  EXPECT_TRUE(tracker.update(scan_of(46, {}), {}).empty());
}

TEST(KalmanTracker, EachTrackTakesItsNearest) {
  KalmanTracker tracker({}, {});
  std::span<const core::Track> tracks;
  for (int k = 0; k < 20; ++k) tracks = tracker.update(scan_of(k, {{60.0, -30.0}, {60.0, 30.0}}), {});
  ASSERT_EQ(tracks.size(), 2U);
  EXPECT_NEAR(tracks[0].state(1), -30.0, 0.5);
  EXPECT_NEAR(tracks[1].state(1), 30.0, 0.5);
}

TEST(KalmanTracker, RefusesParametersOutOfRange) {
  KalmanParams params;
  params.gate_probability = 0.0;
  EXPECT_THROW(KalmanTracker(params, {}), std::invalid_argument);
  params = {};
  params.gate_distance = 0.0;
  EXPECT_THROW(KalmanTracker(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
