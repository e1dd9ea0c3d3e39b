#include "tracking/joint/confirmation.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/joint/track_scenes.hpp"

namespace lookout::tracking {
namespace {

const Eigen::Vector4d kLine(60.0, 0.5, 1.0, 0.0);

TrackerState empty_sea() {
  TrackerState state({}, clear_sonar(), 1);
  state.likelihood.push(scan_of(0, {}));
  return state;
}

std::span<const core::Track> output_of(Confirmation& output, double undetected, TrackerState& state) {
  output.choose(undetected, state);
  return output.publish(state);
}

TEST(Confirmation, AProbableTrackIsConfirmedAndAnUnlikelyOneIsNot) {
  TrackerState state = empty_sea();
  add_track(state, kLine, 3.0);
  add_track(state, {90.0, 9.0, 0.0, 0.0}, -2.0);
  add_track(state, {100.0, -9.0, 0.0, 0.0}, -6.0);
  Confirmation output({}, state.random);
  const auto tracks = output_of(output, 0.0, state);
  ASSERT_EQ(tracks.size(), 2U);  // The third is too improbable to be published.
  EXPECT_EQ(tracks[0].status, core::TrackStatus::confirmed);
  EXPECT_EQ(tracks[1].status, core::TrackStatus::tentative);
  EXPECT_DOUBLE_EQ(tracks[0].state[2], 1.0);
  EXPECT_TRUE(state.tracks[0].confirmed_once);
}

// Expected OSPA with nothing reported and six targets undetected is 20 m; a wrong report costs nothing then.
// But a track that was never confirmed must be probable by itself.
TEST(Confirmation, WithMuchUnseenADoubtfulTrackIsReportedAgain) {
  TrackerState state = empty_sea();
  add_track(state, kLine, -1.0);
  Confirmation output({}, state.random);
  EXPECT_EQ(output_of(output, 6.0, state)[0].status, core::TrackStatus::tentative);  // Never reported.
  state.tracks[0].confirmed_once = true;
  EXPECT_EQ(output_of(output, 6.0, state)[0].status, core::TrackStatus::confirmed);
  EXPECT_EQ(output_of(output, 0.0, state)[0].status, core::TrackStatus::tentative);
}

// Detections bring 3.3 nats at (.3, .3) and 2.5 at (.5, .5), where silence says nothing: ln((1 - e^-x) / x)
// is -1.24 and -1.00, so that 0.36 and 0.60 are needed.
TEST(Confirmation, WhereOddsLeapAFirstReportNeedsLess) {
  ReportParams params;
  params.first_log_odds = 1.6;
  for (const double p : {0.3, 0.5}) {
    core::SonarParams sonar = clear_sonar();
    sonar.miss_probability = sonar.false_alarm_probability = p;
    TrackerState state({}, sonar, 1);
    state.likelihood.push(scan_of(0, {}));
    add_track(state, kLine, 0.5);
    Confirmation output(params, state.random);
    EXPECT_EQ(output_of(output, 6.0, state)[0].status,
              p < 0.4 ? core::TrackStatus::confirmed : core::TrackStatus::tentative);
  }
}

// Where detections alone would do at less than even odds: at (.02, .02) they leap by 6 nats.
TEST(Confirmation, AFirstReportNeverNeedsLessThanEvenOdds) {
  core::SonarParams sonar = clear_sonar();
  sonar.miss_probability = sonar.false_alarm_probability = 0.02;
  TrackerState state({}, sonar, 1);
  state.likelihood.push(scan_of(0, {}));
  ReportParams params;
  params.first_log_odds = 1.0;
  csht::TargetTrack& track = add_track(state, kLine, -0.1);
  Confirmation output(params, state.random);
  EXPECT_EQ(output_of(output, 6.0, state)[0].status, core::TrackStatus::tentative);
  track.log_odds = 0.1;
  EXPECT_EQ(output_of(output, 6.0, state)[0].status, core::TrackStatus::confirmed);
}

TEST(Confirmation, OutOfViewAConfirmedTrackCoasts) {
  TrackerState state = empty_sea();
  csht::TargetTrack& track = add_track(state, kLine, 3.0);
  Confirmation output({}, state.random);
  output_of(output, 0.0, state);
  track.out_of_view = track.coasting = true;
  const auto tracks = output_of(output, 0.0, state);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].status, core::TrackStatus::coasting);
}

TEST(Confirmation, AfterTheCoastATrackIsNotPublished) {
  TrackerState state = empty_sea();
  csht::TargetTrack& track = add_track(state, kLine, 3.0);
  Confirmation output({}, state.random);
  output_of(output, 0.0, state);
  track.out_of_view = true;
  EXPECT_TRUE(output_of(output, 0.0, state).empty());
}

TEST(Confirmation, OutOfViewADoubtfulTrackDoesNotCount) {
  TrackerState state = empty_sea();
  csht::TargetTrack& track = add_track(state, kLine, -0.5);
  track.confirmed_once = track.out_of_view = track.coasting = true;
  Confirmation output({}, state.random);
  const auto tracks = output_of(output, 0.0, state);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].status, core::TrackStatus::tentative);
}

}  // namespace
}  // namespace lookout::tracking
