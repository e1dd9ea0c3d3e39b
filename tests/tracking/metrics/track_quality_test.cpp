#include "tracking/metrics/track_quality.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace lookout::tracking {
namespace {

using Placed = std::vector<std::pair<int, double>>;  // id and north

core::GroundTruth truth_at(int scan, const Placed& targets) {
  core::GroundTruth truth;
  truth.utime = 500'000LL * scan;
  for (const auto& [id, north] : targets) truth.targets.push_back({id, {north, 0.0}, {0.0, 0.0}, true});
  return truth;
}

std::vector<core::Track> tracks_at(const Placed& placed) {
  std::vector<core::Track> tracks(placed.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    tracks[i].id = placed[i].first;
    tracks[i].status = core::TrackStatus::confirmed;
    tracks[i].state = {placed[i].second, 0.0, 0.0, 0.0};
  }
  return tracks;
}

TEST(TrackQuality, ATargetFollowedFromItsThirdScan) {
  TrackQuality quality;
  for (int scan = 0; scan < 20; ++scan)
    quality.add(truth_at(scan, {{1, 50.0}}), tracks_at(scan < 2 ? Placed{} : Placed{{7, 52.0}}));
  const TrackQualityResult result = quality.result();
  EXPECT_DOUBLE_EQ(result.time_to_confirm, 1.0);  // two scans of half a second
  EXPECT_DOUBLE_EQ(result.followed_share, 18.0 / 20.0);
  EXPECT_DOUBLE_EQ(result.count_correct, 18.0 / 20.0);
  EXPECT_DOUBLE_EQ(result.targets.at(0).median_error.value(), 2.0);
  EXPECT_EQ(result.identity_switches, 0);
  EXPECT_EQ(result.identities, 1.0);
  EXPECT_EQ(result.false_per_100s, 0.0);
}

TEST(TrackQuality, PairsAreThoseOfTheNewestScan) {
  TrackQuality quality;
  quality.add(truth_at(0, {{1, 0.0}, {2, 90.0}}), tracks_at({{7, 1.0}, {8, 50.0}}));
  ASSERT_EQ(quality.pairs().size(), 1U);  // the other two are 40 m apart, beyond the gate
  EXPECT_EQ(quality.pairs()[0].target.id, 1);
  EXPECT_EQ(quality.pairs()[0].track.id, 7);
  quality.add(truth_at(1, {{1, 0.0}}), {});
  EXPECT_TRUE(quality.pairs().empty());
}

TEST(TrackQuality, PairsKeepTheirIdentityWhereTargetsMeet) {
  TrackQuality quality;
  for (int scan = 0; scan < 20; ++scan)
    quality.add(truth_at(scan, {{1, 0.0}, {2, 9.0}}), tracks_at({{7, 0.0}, {8, 9.0}}));
  quality.add(truth_at(20, {{1, 4.0}, {2, 5.0}}),
              tracks_at({{7, 4.9}, {8, 4.1}}));  // each nearer to the other
  ASSERT_EQ(quality.pairs().size(), 2U);
  EXPECT_EQ(quality.pairs()[0].track.id, 7);
  EXPECT_EQ(quality.pairs()[1].track.id, 8);
}

TEST(TrackQuality, SwappedTracksAreTwoSwitchesAndHalfPure) {
  TrackQuality quality;
  for (int scan = 0; scan < 40; ++scan)
    quality.add(truth_at(scan, {{1, 0.0}, {2, 8.0}}),
                tracks_at(scan < 20 ? Placed{{1, 0.0}, {2, 8.0}} : Placed{{1, 8.0}, {2, 0.0}}));
  const TrackQualityResult result = quality.result();
  EXPECT_EQ(result.identity_switches, 2);
  EXPECT_DOUBLE_EQ(result.purity, 0.5);
}

TEST(TrackQuality, AMomentarySwapIsNoSwitch) {
  TrackQuality quality;
  for (int scan = 0; scan < 40; ++scan)
    quality.add(truth_at(scan, {{1, 0.0}, {2, 1.0}}),
                tracks_at(scan == 20 ? Placed{{1, 1.0}, {2, 0.0}} : Placed{{1, 0.0}, {2, 1.0}}));
  EXPECT_EQ(quality.result().identity_switches, 0);
}

TEST(TrackQuality, TwinsAndStrangersAreFalseTracks) {
  TrackQuality quality;
  for (int scan = 0; scan <= 20; ++scan)
    quality.add(truth_at(scan, {{1, 0.0}}), tracks_at({{1, 0.0}, {2, 1.0}, {3, 100.0}}));
  EXPECT_DOUBLE_EQ(quality.result().false_per_100s, 20.0);  // two in ten seconds
  EXPECT_DOUBLE_EQ(quality.result().mean_tracks, 3.0);
}

TEST(TrackQuality, ATargetNeverFoundCountsItsWholeTime) {
  TrackQuality quality;
  for (int scan = 0; scan <= 20; ++scan) quality.add(truth_at(scan, {{1, 0.0}}), {});
  EXPECT_DOUBLE_EQ(quality.result().time_to_confirm, 10.0);
  EXPECT_EQ(quality.result().followed_share, 0.0);
}

TEST(TrackQuality, RefusesBadParams) {
  EXPECT_THROW(TrackQuality({.gate = 0.0}), std::invalid_argument);
  EXPECT_THROW(TrackQuality({.identity_scans = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
