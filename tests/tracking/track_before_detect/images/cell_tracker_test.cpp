#include "tracking/track_before_detect/images/cell_tracker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "tests/tracking/track_before_detect/blobs.hpp"

namespace lookout::tracking {
namespace {

TEST(CellTracker, APixelTargetIsConfirmedAndFollowed) {
  core::Random random(1000);
  CellTracker tracker;
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
  CellTracker tracker;
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
  CellTrackerParams params;
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

TEST(CellTracker, RefusesParametersOutOfRange) {
  CellTrackerParams params;
  params.existence.survival = 0.0;
  EXPECT_THROW(CellTracker{params}, std::invalid_argument);
  params = {};
  params.measurement.gate_columns = 16;
  EXPECT_THROW(CellTracker{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
