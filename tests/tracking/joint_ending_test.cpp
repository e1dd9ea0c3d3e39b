#include "tracking/joint_ending.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/tracking/joint_scenes.hpp"

namespace lookout::tracking {
namespace {

const Eigen::Vector4d kLine(60.0, 0.5, 1.0, 0.0);

JointState empty_sea() {
  JointState state({}, clear_sonar(), 1);
  state.likelihood.push(scan_of(0, {}));
  return state;
}

TEST(JointEnding, OfTwoOnOneTargetTheLessProbableEnds) {
  JointState state = empty_sea();
  JointTrack& sure = add_track(state, kLine, 5.0);
  JointTrack& twin = add_track(state, kLine + Eigen::Vector4d(1.0, 1.0, 0.1, 0.0), 2.0);
  JointEnding({}).end_twins(state);
  EXPECT_TRUE(sure.used);
  EXPECT_FALSE(twin.used);
}

TEST(JointEnding, AConfirmedTrackOutlivesATentativeTwinThatIsMoreProbable) {
  JointState state = empty_sea();
  JointTrack& old = add_track(state, kLine, 1.0);
  old.confirmed_once = true;
  JointTrack& twin = add_track(state, kLine, 2.0);
  JointEnding({}).end_twins(state);
  EXPECT_TRUE(old.used);
  EXPECT_FALSE(twin.used);
}

TEST(JointEnding, NeighboursOnOtherCoursesAreNoTwins) {
  JointState state = empty_sea();
  add_track(state, kLine, 1.0);
  JointTrack& crossing = add_track(state, {60.0, 0.5, 0.0, 1.0}, 1.0);
  JointEnding({}).end_twins(state);
  EXPECT_TRUE(crossing.used);
}

TEST(JointEnding, TooLittleEvidenceEndsATrackLaterOnceItWasConfirmed) {
  const JointLifeParams params;
  JointState state = empty_sea();
  JointTrack& tentative = add_track(state, kLine, params.end_log_odds - 1.0);
  JointTrack& confirmed = add_track(state, {90.0, 9.0, 0.0, 0.0}, params.end_log_odds - 1.0);
  confirmed.confirmed_once = true;
  JointEnding(params).end_lives(state);
  EXPECT_TRUE(tentative.used);
  EXPECT_FALSE(confirmed.used);
}

TEST(JointEnding, OutOfViewAConfirmedTrackCoastsAndIsKeptInCaseItReturns) {
  JointLifeParams params;  // Scans every half second.
  params.coast_s = 10.0;
  params.return_s = 15.0;
  JointState state = empty_sea();
  JointTrack& track = add_track(state, kLine, 5.0);
  track.confirmed_once = true;
  track.visible_share = 0.2;
  const JointEnding ending(params);
  int scans = 0, coasting = 0;
  for (; track.used && scans < 100; ++scans) {
    state.likelihood.push(scan_of(scans + 1, {}));
    ending.end_lives(state);
    coasting += track.coasting ? 1 : 0;
  }
  EXPECT_EQ(coasting, 19);  // In view at 0 s for the last time; coasting from 0.5 to 9.5 s,
  EXPECT_EQ(scans, 30);     // kept at 14.5 s, gone at 15 s.
}

TEST(JointEnding, OutOfViewATentativeTrackEndsAtOnce) {
  JointState state = empty_sea();
  JointTrack& track = add_track(state, kLine, 5.0);
  track.visible_share = 0.2;
  JointEnding({}).end_lives(state);
  EXPECT_FALSE(track.used);
}

}  // namespace
}  // namespace lookout::tracking
