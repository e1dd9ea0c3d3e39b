#include "tracking/baselines/gnn_tracker.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/patch_sea.hpp"
#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

TEST(GnnTracker, ConfirmsOnTheMthDetectionAndFollows) {
  GnnTracker tracker({}, {});
  for (int k = 0; k < 5; ++k)
    ASSERT_EQ(tracker.update(scan_of(k, {{50.0 + 0.5 * k, 0.0}}), {})[0].status,
              core::TrackStatus::tentative);
  std::span<const core::Track> tracks;
  for (int k = 5; k < 40; ++k) tracks = tracker.update(scan_of(k, {{50.0 + 0.5 * k, 0.0}}), {});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_NEAR(tracks[0].state(0), 50.0 + 0.5 * 39, 0.1);
  EXPECT_NEAR(tracks[0].state(2), 1.0, 0.05);
}

TEST(GnnTracker, OneDetectionMakesNoConfirmedTrack) {
  GnnTracker tracker({}, {});
  tracker.update(scan_of(0, {{50.0, 0.0}}), {});
  std::span<const core::Track> tracks;
  for (int k = 1; k < 9; ++k) tracks = tracker.update(scan_of(k, {}), {});
  EXPECT_TRUE(tracks.empty());
}

TEST(GnnTracker, TwoTargetsKeepTheirIdentities) {
  GnnTracker tracker({}, {});
  std::span<const core::Track> tracks;
  for (int k = 0; k < 30; ++k)
    tracks = tracker.update(scan_of(k, {{60.0, -20.0 + 0.5 * k}, {90.0 - 0.5 * k, 20.0}}), {});
  ASSERT_EQ(tracks.size(), 2U);
  EXPECT_NEAR(tracks[0].state(1), -5.5, 0.5);
  EXPECT_NEAR(tracks[1].state(0), 75.5, 0.5);
}

TEST(GnnTracker, LearnsWhereFalseReturnsAreDense) {
  expect_map_finds_patch<GnnTracker, GnnParams>();
}

TEST(GnnTracker, RefusesParametersOutOfRange) {
  GnnParams params;
  params.gate_probability = 1.0;
  EXPECT_THROW(GnnTracker(params, {}), std::invalid_argument);
  params = {};
  params.motion.acceleration_sigma = -1.0;
  EXPECT_THROW(GnnTracker(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
