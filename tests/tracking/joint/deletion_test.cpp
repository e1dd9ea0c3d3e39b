#include "tracking/joint/deletion.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/tracking/joint/track_scenes.hpp"

namespace lookout::tracking {
namespace {

const Eigen::Vector4d kLine(60.0, 0.5, 1.0, 0.0);

TrackerState empty_sea() {
  TrackerState state({}, clear_sonar(), 1);
  state.likelihood.push(scan_of(0, {}));
  return state;
}

TEST(Deletion, OfTwoOnOneTargetTheLessProbableEnds) {
  TrackerState state = empty_sea();
  csht::TargetTrack& sure = add_track(state, kLine, 5.0);
  csht::TargetTrack& twin = add_track(state, kLine + Eigen::Vector4d(1.0, 1.0, 0.1, 0.0), 2.0);
  Deletion({}).end_twins(state);
  EXPECT_TRUE(sure.used);
  EXPECT_FALSE(twin.used);
}

TEST(Deletion, AConfirmedTrackOutlivesATentativeTwinThatIsMoreProbable) {
  TrackerState state = empty_sea();
  csht::TargetTrack& old = add_track(state, kLine, 1.0);
  old.confirmed_once = true;
  csht::TargetTrack& twin = add_track(state, kLine, 2.0);
  Deletion({}).end_twins(state);
  EXPECT_TRUE(old.used);
  EXPECT_FALSE(twin.used);
}

TEST(Deletion, NeighboursOnOtherCoursesAreNoTwins) {
  TrackerState state = empty_sea();
  add_track(state, kLine, 1.0);
  csht::TargetTrack& crossing = add_track(state, {60.0, 0.5, 0.0, 1.0}, 1.0);
  Deletion({}).end_twins(state);
  EXPECT_TRUE(crossing.used);
}

TEST(Deletion, TooLittleEvidenceEndsATrackLaterOnceItWasConfirmed) {
  const JointTrackerParams params;
  TrackerState state = empty_sea();
  csht::TargetTrack& tentative = add_track(state, kLine, params.life.end_log_odds - 1.0);
  csht::TargetTrack& confirmed = add_track(state, {90.0, 9.0, 0.0, 0.0}, params.life.end_log_odds - 1.0);
  confirmed.confirmed_once = true;
  Deletion(params).end_lives(state);
  EXPECT_TRUE(tentative.used);
  EXPECT_FALSE(confirmed.used);
}

// A sonar ahead and one to starboard, in turn: what the first has in view stays in view at the other's scans.
TEST(Deletion, InViewOfAnotherSonarATrackIsInView) {
  TrackerState state({}, clear_sonar(), 1);
  const auto scan_of_sonar = [](int index, std::int32_t sensor_id) {
    core::PosedScan posed = scan_of(index, {});
    posed.scan.sensor_id = sensor_id;
    if (sensor_id == 2) posed.T_earth_sonar.heading = core::radians(90.0);
    return posed;
  };
  state.take(scan_of_sonar(0, 1));
  csht::TargetTrack& track = add_track(state, kLine, 1.0);
  for (int index = 1; index < 6; ++index) {
    track.visible_share = index % 2 == 0 ? 1.0 : 0.0;
    state.take(scan_of_sonar(index, index % 2 == 0 ? 1 : 2));
    Deletion({}).end_lives(state);
    ASSERT_TRUE(track.used);
    EXPECT_FALSE(track.out_of_view);
    EXPECT_EQ(track.visible_share, 1.0);
  }
  for (int index = 6; index < 8; ++index) {  // It has left the view of both.
    track.visible_share = 0.0;
    state.take(scan_of_sonar(index, index % 2 == 0 ? 1 : 2));
    Deletion({}).end_lives(state);
  }
  EXPECT_FALSE(track.used);
}

TEST(Deletion, OutOfViewAConfirmedTrackCoastsAndIsKeptInCaseItReturns) {
  JointTrackerParams params;  // Scans every half second.
  params.life.coast_s = 10.0;
  params.life.return_s = 15.0;
  TrackerState state = empty_sea();
  csht::TargetTrack& track = add_track(state, kLine, 5.0);
  track.confirmed_once = true;
  track.visible_share = 0.2;
  const Deletion deletion(params);
  int scans = 0, coasting = 0;
  for (; track.used && scans < 100; ++scans) {
    state.likelihood.push(scan_of(scans + 1, {}));
    deletion.end_lives(state);
    coasting += track.coasting ? 1 : 0;
  }
  EXPECT_EQ(coasting, 19);  // In view at 0 s for the last time; coasting from 0.5 to 9.5 s,
  EXPECT_EQ(scans, 30);     // kept at 14.5 s, gone at 15 s.
}

TEST(Deletion, OutOfViewATentativeTrackEndsAtOnce) {
  TrackerState state = empty_sea();
  csht::TargetTrack& track = add_track(state, kLine, 5.0);
  track.visible_share = 0.2;
  Deletion({}).end_lives(state);
  EXPECT_FALSE(track.used);
}

}  // namespace
}  // namespace lookout::tracking
