#include "tracking/joint/retrodiction.hpp"

#include <gtest/gtest.h>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

csht::ScanHistory twenty_scans() {
  csht::ScanHistory scans({}, {}, 40);
  for (int k = 0; k < 20; ++k) scans.push(scan_of(k, {}));
  return scans;
}

// At 70 m north after 9.5 s, northwards at 1 m/s, since 2 s.
csht::TargetTrack sure_track() {
  csht::TargetTrack track;
  track.used = track.confirmed_once = track.reported = true;
  track.id = 3;
  track.log_odds = track.highest_log_odds = 5.0;
  track.moments.mean << 70.0, 5.0, 1.0, 0.0, 0.0, 0.0;
  track.first_utime = 2 * kSecond;
  track.last_detection_utime = 9 * kSecond;
  return track;
}

TEST(Retrodiction, DrawsATrackBackAlongItsLine) {
  Retrodiction retrodiction;
  const csht::ScanHistory scans = twenty_scans();
  const std::vector<csht::TargetTrack> tracks{sure_track()};
  const auto past = retrodiction.at(4'500'000, tracks, scans, 0.5);
  ASSERT_EQ(past.size(), 1U);
  EXPECT_DOUBLE_EQ(past[0].state[0], 65.0);
  EXPECT_EQ(past[0].status, core::TrackStatus::confirmed);
  EXPECT_TRUE(retrodiction.at(1 * kSecond, tracks, scans, 0.5).empty());  // Before its start.
}

TEST(Retrodiction, RemembersATrackThatEndedUpToItsLastDetection) {
  Retrodiction retrodiction;
  const csht::ScanHistory scans = twenty_scans();
  retrodiction.retire(sure_track(), 9'500'000, 4.0);
  EXPECT_EQ(retrodiction.at(8 * kSecond, {}, scans, 0.5).size(), 1U);
  EXPECT_TRUE(retrodiction.at(9'500'000, {}, scans, 0.5).empty());
  retrodiction.forget_before(9'100'000);
  EXPECT_TRUE(retrodiction.at(8 * kSecond, {}, scans, 0.5).empty());
}

TEST(Retrodiction, AfterTheCoastATrackIsOneThatWasLastInView) {
  Retrodiction retrodiction;
  csht::TargetTrack track = sure_track();
  track.out_of_view = true;
  track.in_view_utime = 6 * kSecond;
  const std::vector<csht::TargetTrack> tracks{track};
  const csht::ScanHistory scans = twenty_scans();
  EXPECT_EQ(retrodiction.at(6 * kSecond, tracks, scans, 0.5).size(), 1U);
  EXPECT_TRUE(retrodiction.at(7 * kSecond, tracks, scans, 0.5).empty());
}

TEST(Retrodiction, WhatWasNeverSureWasFalse) {
  Retrodiction retrodiction;
  csht::TargetTrack track = sure_track();
  track.highest_log_odds = 2.0;
  retrodiction.retire(track, 9'500'000, 4.0);
  EXPECT_TRUE(retrodiction.at(8 * kSecond, {}, twenty_scans(), 0.5).empty());
}

TEST(Retrodiction, OutsideTheSectorItCoasts) {
  Retrodiction retrodiction;
  csht::TargetTrack track = sure_track();
  track.moments.mean << 10.0, 70.0, 0.0, 0.0, 0.0, 0.0;
  const std::vector<csht::TargetTrack> tracks{track};
  const auto past = retrodiction.at(5 * kSecond, tracks, twenty_scans(), 0.5);
  ASSERT_EQ(past.size(), 1U);
  EXPECT_EQ(past[0].status, core::TrackStatus::coasting);
}

}  // namespace
}  // namespace lookout::tracking
