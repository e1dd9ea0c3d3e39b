#include "tracking/joint/tracker_state.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/sonar_scene.hpp"

namespace lookout::tracking {
namespace {

TrackerState two_slots() {
  JointTrackerParams params;
  params.hypotheses.max_tracks = 2;
  TrackerState state(params, {}, 1);
  state.likelihood.push(scan_of(0, {{60.0, 0.5}}));
  return state;
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
