#include "tracking/joint/tracker_state.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

TrackerState two_slots() {
  JointTrackerParams params;
  params.life.max_tracks = 2;
  TrackerState state(params, {}, 1);
  state.likelihood.push(scan_of(0, {{60.0, 0.5}}));
  return state;
}

TEST(TrackerState, FillsSlotsUpToTheLimitAndCountsIdentities) {
  TrackerState state = two_slots();
  for (int k = 1; k <= 2; ++k) {
    csht::TargetTrack* track = state.free_track();
    ASSERT_NE(track, nullptr);
    EXPECT_EQ(track->id, k);
    EXPECT_EQ(state.slot_of(*track), k - 1);
    track->used = true;
  }
  EXPECT_EQ(state.free_track(), nullptr);
}

TEST(TrackerState, AnEndedTrackGivesItsSlotAndItsClaimsBack) {
  TrackerState state = two_slots();
  csht::TargetTrack& track = *state.free_track();
  track.used = true;
  state.likelihood.set_existence(0, 1.0);
  state.likelihood.add_claim(0, {0, 45, 60.0F, 1.0F});
  EXPECT_GT(state.likelihood.explained(0, 45, 60.0), 0.9);
  state.end(track, DecisionKind::end, "over");
  EXPECT_EQ(state.likelihood.explained(0, 45, 60.0), 0.0);
  EXPECT_EQ(state.free_track(), &track);
  EXPECT_EQ(track.id, 2);  // A new identity.
}

TEST(TrackerState, OnlyTheEndOfWhatWasConfirmedIsToldAndRemembered) {
  TrackerState state = two_slots();
  std::vector<DecisionKind> told;
  state.log = [&told](const TrackDecision& decision) { told.push_back(decision.kind); };
  csht::TargetTrack& track = *state.free_track();
  track.highest_log_odds = 5.0;
  state.end(track, DecisionKind::end, "over");
  EXPECT_TRUE(told.empty());
  track.confirmed_once = true;
  state.end(track, DecisionKind::end, "over");
  EXPECT_EQ(told, std::vector<DecisionKind>{DecisionKind::end});
  EXPECT_EQ(state.retrodiction.at(0, {}, state.scans(), 0.5).size(), 1U);
}

}  // namespace
}  // namespace lookout::tracking
