#include "tools/experiments/tracking/boat_score.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::tools {
namespace {

core::Track track_at(std::int64_t id, double north, double east,
                     core::TrackStatus status = core::TrackStatus::confirmed) {
  core::Track track;
  track.id = id;
  track.status = status;
  track.state = {north, east, 0.0, 0.0};
  return track;
}

/// A boat 50 m north of the radar, heard in the scans that are true.
std::vector<TimedScan> scans_of_a_boat(const std::vector<bool>& heard) {
  std::vector<TimedScan> scans;
  for (const bool is_heard : heard) {
    TimedScan scan;
    scan.truth.utime = scan.posed.scan.utime = 1'000'000 * static_cast<std::int64_t>(scans.size());
    core::TargetTruth boat;
    boat.id = 1;
    boat.position = {50.0, 0.0};
    scan.truth.targets.push_back(boat);
    if (is_heard) scan.posed.scan.returns.push_back({0.0, 52.0});
    scans.push_back(scan);
  }
  return scans;
}

// Off by 3 m; a second track 30 m away costs as much as a missed boat, one 50 m away is somebody else's.
TEST(BoatScore, OspaCountsTheTracksNearABoat) {
  const auto scans = scans_of_a_boat({true});
  EXPECT_NEAR(ospa_near(scans, {{track_at(1, 53.0, 0.0)}}, {}), 3.0, 1e-9);
  EXPECT_NEAR(ospa_near(scans, {{track_at(1, 53.0, 0.0), track_at(2, 100.0, 0.0)}}, {}), 3.0, 1e-9);
  EXPECT_NEAR(ospa_near(scans, {{track_at(1, 53.0, 0.0), track_at(2, 80.0, 0.0)}}, {}),
              std::sqrt((9.0 + 400.0) / 2.0), 1e-9);
  EXPECT_NEAR(ospa_near(scans, {{track_at(1, 53.0, 0.0, core::TrackStatus::tentative)}}, {}), 20.0, 1e-9);
}

TEST(BoatScore, ErrorsAreComparedWhereBothHaveATrack) {
  const auto scans = scans_of_a_boat({true, true, true});
  const TracksOfScans own{{track_at(1, 53.0, 0.0)}, {track_at(1, 55.0, 0.0)}, {track_at(1, 69.0, 0.0)}};
  const TracksOfScans rival{{track_at(1, 51.0, 0.0)}, {track_at(1, 52.0, 0.0)}, {}};
  const Metrics metrics = excess_errors(scans, own, rival, {});
  EXPECT_NEAR(metrics.at("excess_error_m_target1").value, 5.0 - 2.0,
              1e-9);  // The upper of two is the median.
}

TEST(BoatScore, ASilenceIsKeptByTheTrackThatWasOnTheBoat) {
  const auto scans = scans_of_a_boat({true, true, false, false, false, true});
  const std::vector<core::Track> on{track_at(7, 50.0, 0.0)}, other{track_at(8, 50.0, 0.0)};
  const Metrics kept = silences(scans, {on, on, on, on, on, on}, {});
  EXPECT_EQ(kept.at("silences").value, 1.0);
  EXPECT_EQ(kept.at("silence_kept_share").value, 1.0);
  EXPECT_EQ(silences(scans, {on, on, on, on, {}, on}, {}).at("silence_kept_share").value, 0.0);
  EXPECT_EQ(silences(scans, {on, on, on, on, other, on}, {}).at("silence_kept_share").value, 0.0);
}

TEST(BoatScore, TwoMissesOrABoatWithoutATrackAreNoSilence) {
  const std::vector<core::Track> on{track_at(7, 50.0, 0.0)};
  const auto two = scans_of_a_boat({true, false, false, true});
  EXPECT_EQ(silences(two, {on, on, on, on}, {}).at("silences").value, 0.0);
  const auto three = scans_of_a_boat({true, false, false, false});
  EXPECT_EQ(silences(three, {{}, {}, {}, {}}, {}).at("silences").value, 0.0);
}

}  // namespace
}  // namespace lookout::tools
