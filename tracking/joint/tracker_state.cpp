#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

void TrackerState::end(csht::TargetTrack& track, DecisionKind kind, const char* reason) {
  release(track);
  if (!track.confirmed_once) return;
  if (kind == DecisionKind::end) retrodiction.retire(track, now(), settled_log_odds_);
  decide(track, kind, track.log_odds, reason);
}

void TrackerState::decide(const csht::TargetTrack& track, DecisionKind kind, double evidence,
                          const char* reason) const {
  if (log) log({now(), track.id, kind, evidence, reason});
}

}  // namespace lookout::tracking
