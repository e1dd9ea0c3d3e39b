#include "tracking/joint/scan_update.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracking/joint/track_scenes.hpp"

namespace lookout::tracking {
namespace {

const Eigen::Vector4d kLine(60.0, 0.5, 1.0, 0.0);

TEST(ScanUpdate, PredictionMovesTracksAndLetsThemFade) {
  JointTrackerParams params;
  TrackerState state(params, clear_sonar(), 1);
  state.likelihood.push(scan_of(0, {}));
  csht::TargetTrack& track = add_track(state, kLine, 0.0);
  ScanUpdate(params).predict(5.0, state);
  EXPECT_DOUBLE_EQ(track.moments.mean[0], 65.0);
  EXPECT_NEAR(track.existence(), 0.5 * std::exp(-5.0 / params.life.mean_life_s), 1e-12);
}

// ln[(1 - P_M) N(0; 0, sigma^2) R / P_F] for a return in the middle of the beam at the very range.
TEST(ScanUpdate, AReturnRaisesTheOddsByItsLikelihoodRatio) {
  TrackerState state({}, clear_sonar(), 1);
  const Eigen::Vector2d middle =
      60.0 * Eigen::Vector2d(std::cos(core::radians(0.5)), std::sin(core::radians(0.5)));
  state.likelihood.push(scan_of(0, {middle}));
  csht::TargetTrack& track = add_track(state, {middle.x(), middle.y(), 0.0, 0.0}, 1.0);
  ScanUpdate({}).update(state);
  const double height = 150.0 / (3.0 * std::sqrt(2.0 * 3.14159265358979));
  EXPECT_NEAR(track.log_odds, 1.0 + std::log(0.9 * height / 0.1 + std::exp(-8.0)), 1e-4);
  EXPECT_DOUBLE_EQ(track.visible_share, 1.0);
}

TEST(ScanUpdate, SilenceSpeaksAgainstATrackInClearWater) {
  TrackerState state({}, clear_sonar(), 1);
  state.likelihood.push(scan_of(0, {}));
  csht::TargetTrack& track = add_track(state, kLine, 1.0);
  ScanUpdate({}).update(state);
  EXPECT_NEAR(track.log_odds, 1.0 + std::log(0.1 / 0.9), 1e-4);
}

// The nearer of two in a beam owns the return; the farther one learns next to nothing.
TEST(ScanUpdate, BehindASureTrackNothingIsLearnt) {
  TrackerState state({}, clear_sonar(), 1);
  state.likelihood.push(scan_of(0, {{60.0, 0.5}}));
  add_track(state, {60.0, 0.5, 0.0, 0.0}, 20.0);
  csht::TargetTrack& behind = add_track(state, {90.0, 0.8, 0.0, 0.0}, 1.0);
  ScanUpdate({}).update(state);
  EXPECT_NEAR(behind.log_odds, 1.0, 0.01);
}

// Out of view no scan says anything: eight trajectories of which one carries the weight, behind the sonar,
// stay these eight, and are not drawn anew where nothing speaks against any.
TEST(ScanUpdate, ATrackOutOfViewIsNotDrawnAnew) {
  TrackerState state({}, clear_sonar(), 1);
  push_target(state, 12);
  csht::TargetTrack& track = add_track(state, {-60.0, 0.0, 1.0, 0.0}, 0.0);
  track.cloud.resize(8);
  for (std::size_t i = 0; i < 8; ++i) {
    track.cloud.north[i] = -60.0 - static_cast<double>(i);
    track.cloud.east[i] = track.cloud.east_velocity[i] = 0.0;
    track.cloud.north_velocity[i] = 1.0;
    track.cloud.weight[i] = i == 0 ? 0.93 : 0.01;
  }
  track.moments = track.cloud.moments();
  track.first_scan = 0;
  track.out_of_view = true;
  ScanUpdate({}).update(state);
  EXPECT_EQ(track.cloud.size(), 8U);
  EXPECT_NEAR(track.moments.mean[0], -60.0 - 0.01 * 28, 1e-9);
}

// Without beams, two targets 60 m apart both teach of their motion: neither's claims concern the other.
TEST(ScanUpdate, OfAPointSensorAClaimElsewhereLeavesATracksMotionToBeJudged) {
  core::SonarParams radar = clear_sonar();
  radar.false_alarm_probability.reset();
  radar.clutter_per_scan = 1.0;
  TrackerState state({}, radar, 1);
  state.likelihood.push(scan_of(0, {{60.0, 0.5}, {120.0, 0.5}}));
  add_track(state, {120.0, 0.5, 0.0, 0.0}, 5.0);
  csht::TargetTrack& missed = add_track(state, {69.0, 0.5, 0.0, 0.0}, 5.0);  // Three sigma off its return.
  ScanUpdate({}).update(state);
  EXPECT_LT(missed.recent.sum(1), missed.recent.expected(1) - 1.0);
}

}  // namespace
}  // namespace lookout::tracking
