#include "tracking/track_before_detect/images/cell_peaks.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/track_before_detect/blobs.hpp"

namespace lookout::tracking {
namespace {

const PixelGeometry kGeometry(120, 80);

ScaleSpace seen(const std::vector<Eigen::Vector2d>& targets) {
  core::Random random(1000);
  ScaleSpaceParams params;
  params.same_on_both_axes = true;
  params.largest = {1.5, 1.5};
  ScaleSpace scales(params, 1.9);
  scales.apply(blobs(targets, 8.0, random), {1.0, 1.0}, {});
  return scales;
}

CellTrack track_at(const Eigen::Vector2d& position, double sigma) {
  CellTrack track;
  track.state.head<2>() = position;
  track.covariance.topLeftCorner<2, 2>() = sigma * sigma * Eigen::Matrix2d::Identity();
  track.age = 1;
  return track;
}

TEST(CellPeaks, APeakNearATrackIsItsOwnAndAWeakOneInItsColumnsItsSidelobe) {
  const CellPeaks peaks({});
  const ScaleSpace scales = seen({{60.0, 40.0}});
  const CellTrack track = track_at({60.0, 40.0}, 0.3);
  EXPECT_TRUE(peaks.belongs_to(scales, kGeometry, track, peak_at(scales, {62.0, 41.0}, 0)));
  EXPECT_FALSE(peaks.belongs_to(scales, kGeometry, track, {0, {20.0, 10.0}, 0.1, 0.0}));
  EXPECT_TRUE(peaks.belongs_to(scales, kGeometry, track, {0, {60.0, 60.0}, 0.1, 0.0}));
  EXPECT_FALSE(peaks.belongs_to(scales, kGeometry, track, {0, {60.0, 60.0}, 100.0, 0.0}));
}

TEST(CellPeaks, OnlyAConfirmedTrackTakesAPeak) {
  const CellPeaks peaks({});
  const ScaleSpace scales = seen({{60.0, 40.0}});
  std::vector<CellTrack> tracks{track_at({60.0, 40.0}, 0.3)};
  const Candidate peak = peak_at(scales, {60.0, 40.0}, 0);
  EXPECT_FALSE(peaks.is_taken(scales, kGeometry, tracks, peak));
  tracks[0].confirmed = true;
  EXPECT_TRUE(peaks.is_taken(scales, kGeometry, tracks, peak));
}

TEST(CellPeaks, ASureTrackStartsAtItsPredictionAndAnUnsureOneAtThePeakInReach) {
  CellPeaks peaks({});
  ScaleSpace scales = seen({{60.0, 40.0}});
  peaks.find(scales);
  peaks.choose_starts(scales, kGeometry, {track_at({57.0, 40.0}, 0.1), track_at({57.0, 40.0}, 3.0)});
  ASSERT_EQ(peaks.starts().size(), 2u);
  EXPECT_EQ(peaks.starts()[0], Eigen::Vector2d(57.0, 40.0));
  EXPECT_LT((peaks.starts()[1] - Eigen::Vector2d(60.0, 40.0)).norm(), 1.0);
}

// Two equal peaks either side of the prediction: either may be it. Without room for a track there is none.
TEST(CellPeaks, ATrackAtItsSecondFrameBranchesWhereThereIsRoom) {
  CellExistenceParams params;
  ScaleSpace scales = seen({{52.0, 40.0}, {68.0, 40.0}});
  CellPeaks peaks(params);
  peaks.find(scales);
  peaks.choose_starts(scales, kGeometry, {track_at({60.0, 40.0}, 6.0)});
  ASSERT_EQ(peaks.branches().size(), 1u);
  EXPECT_GT((peaks.branches()[0].start - peaks.starts()[0]).norm(), 10.0);
  params.max_tracks = 1;
  CellPeaks full(params);
  full.find(scales);
  full.choose_starts(scales, kGeometry, {track_at({60.0, 40.0}, 6.0)});
  EXPECT_TRUE(full.branches().empty());
}

}  // namespace
}  // namespace lookout::tracking
