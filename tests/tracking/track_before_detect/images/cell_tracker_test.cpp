#include "tracking/track_before_detect/images/cell_tracker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "tests/tracking/track_before_detect/blobs.hpp"

namespace lookout::tracking {
namespace {

/// Of pictures, in which a target may stand.
CellTrackerParams of_pictures() {
  CellTrackerParams params;
  params.standing.judged = false;
  params.scales.same_on_both_axes = true;
  params.scales.largest = {1.5, 1.5};
  return params;
}

TEST(CellTracker, APixelTargetIsConfirmedAndFollowed) {
  core::Random random(1000);
  CellTracker tracker(of_pictures());
  const PixelGeometry geometry(120, 80);
  std::vector<CellTrack> tracks;
  for (int t = 0; t < 30; ++t)
    tracks = tracker.update(blobs({{20.0 + 1.5 * t, 40.0}}, 5.0, random), geometry, t);
  std::erase_if(tracks, [](const CellTrack& track) { return !track.confirmed; });
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_NEAR(tracks[0].state[0], 20.0 + 1.5 * 29, 0.6);
  EXPECT_NEAR(tracks[0].state[1], 40.0, 0.6);
  EXPECT_NEAR(tracks[0].state[2], 1.5, 0.2);
}

TEST(CellTracker, ATrackWithoutItsTargetEnds) {
  core::Random random(1001);
  CellTracker tracker(of_pictures());
  const PixelGeometry geometry(120, 80);
  std::vector<CellTrack> tracks;
  for (int t = 0; t < 20; ++t) tracks = tracker.update(blobs({{50.0, 40.0}}, 6.0, random), geometry, t);
  EXPECT_TRUE(
      std::any_of(tracks.begin(), tracks.end(), [](const CellTrack& track) { return track.confirmed; }));
  for (int t = 20; t < 45; ++t) tracks = tracker.update(blobs({}, 0.0, random), geometry, t);
  EXPECT_FALSE(
      std::any_of(tracks.begin(), tracks.end(), [](const CellTrack& track) { return track.confirmed; }));
}

// Its block holds the brightest peak of the frame all the time, yet it takes nothing of it: a track beside a
// target, once confirmed, held the target's place with an error of metres.
TEST(CellTracker, ABrightBlockThatATrackDoesNotMeasureConfirmsNothing) {
  core::Random random(1002);
  CellTrackerParams params = of_pictures();
  params.measurement.min_intensity = 1e6;
  CellTracker tracker(params);
  const PixelGeometry geometry(120, 80);
  for (int t = 0; t < 20; ++t) {
    for (const CellTrack& track : tracker.update(blobs({{50.0, 40.0}}, 6.0, random), geometry, t)) {
      EXPECT_FALSE(track.confirmed) << t;
      EXPECT_FALSE(track.measured) << t;
    }
  }
}

TEST(CellTracker, WhatStandsIsClaimedAsBackgroundAndConfirmedNoLonger) {
  core::Random random(1003);
  CellTrackerParams params = of_pictures();
  params.standing.judged = true;
  CellTracker tracker(params);
  const PixelGeometry geometry(120, 80);
  bool said_to_stand = false;
  for (int t = 0; t < 30; ++t) {
    tracker.update(blobs({{50.0, 40.0}}, 6.0, random), geometry, t);
    for (const CellWindow& window : tracker.claims()->standing) said_to_stand |= window.contains(50, 40);
  }
  EXPECT_TRUE(said_to_stand);
  for (const CellTrack& track : tracker.tracks())
    EXPECT_FALSE(track.confirmed && (track.state.head<2>() - Eigen::Vector2d(50.0, 40.0)).norm() < 3.0);
}

// Noise stands nowhere: taken for background its cells would have kept a level learnt of a few pings, and
// from those false tracks rose.
TEST(CellTracker, NoiseIsNotClaimedAsStanding) {
  core::Random random(1005);
  CellTrackerParams params = of_pictures();
  params.standing.judged = true;
  CellTracker tracker(params);
  const PixelGeometry geometry(120, 80);
  std::size_t claimed = 0;
  for (int t = 0; t < 40; ++t) {
    tracker.update(blobs({}, 0.0, random), geometry, t);
    claimed += tracker.claims()->standing.size();
  }
  EXPECT_LE(claimed, 2u);
}

// A wall gives faint tracks at every ping: kept from the background for them, it was never learnt.
TEST(CellTracker, ATargetIsKeptFromTheBackgroundAndNoiseIsNot) {
  core::Random random(1006);
  CellTracker tracker(of_pictures());
  const PixelGeometry geometry(120, 80);
  std::size_t tracked = 0, kept = 0;
  for (int t = 0; t < 20; ++t) {
    tracked += tracker.update(blobs({}, 0.0, random), geometry, t).size();
    kept += tracker.claims()->targets.size();
  }
  EXPECT_GT(tracked, 50 * kept);
  for (int t = 20; t < 25; ++t) tracker.update(blobs({{1.5 * t, 40.0}}, 6.0, random), geometry, t);
  const auto& targets = tracker.claims()->targets;
  EXPECT_TRUE(
      std::any_of(targets.begin(), targets.end(), [](const CellWindow& w) { return w.contains(36, 40); }));
}

TEST(CellTracker, ATargetFasterThanItsSignatureAFrameIsFollowed) {
  core::Random random(1004);
  CellTrackerParams params = of_pictures();
  params.motion.start_speed_sigma = 4.0;
  params.motion.max_speed = 12.0;
  CellTracker tracker(params);
  const PixelGeometry geometry(120, 80);
  for (int t = 0; t < 12; ++t) tracker.update(blobs({{10.0 + 8.0 * t, 40.0}}, 8.0, random), geometry, t);
  const auto& tracks = tracker.tracks();
  const auto found =
      std::find_if(tracks.begin(), tracks.end(), [](const CellTrack& t) { return t.confirmed; });
  ASSERT_NE(found, tracks.end());
  EXPECT_NEAR(found->state[0], 98.0, 1.0);
  EXPECT_NEAR(found->state[2], 8.0, 0.3);
}

TEST(CellTracker, RefusesParametersOutOfRange) {
  CellTrackerParams params;
  params.existence.lifetime = 0.0;
  EXPECT_THROW(CellTracker{params}, std::invalid_argument);
  params = {};
  params.measurement.gate_columns = 16;
  EXPECT_THROW(CellTracker{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
