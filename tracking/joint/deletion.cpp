#include "tracking/joint/deletion.hpp"

#include <algorithm>

namespace lookout::tracking {
namespace {

double seconds_out_of_view(const csht::TargetTrack& track, const TrackerState& state) {
  return core::seconds(state.now() - track.in_view_utime);
}

}  // namespace

void Deletion::end_twins(TrackerState& state) const {
  for (std::size_t a = 0; a < state.tracks.size(); ++a) {
    for (std::size_t b = 0; b < a && state.tracks[a].used; ++b) {
      csht::TargetTrack &first = state.tracks[a], &second = state.tracks[b];
      if (!second.used || !twins(first, second)) continue;
      const bool first_goes = first.confirmed_once == second.confirmed_once ? first.log_odds < second.log_odds
                                                                            : second.confirmed_once;
      state.end(first_goes ? first : second, DecisionKind::merge, "on the same target as a surer track");
    }
  }
}

bool Deletion::twins(const csht::TargetTrack& a, const csht::TargetTrack& b) const {
  const csht::Trajectory offset = a.moments.mean - b.moments.mean;
  return offset.head<2>().norm() <= params_.twin_distance &&
         offset.segment<2>(2).norm() <= params_.twin_speed;
}

void Deletion::end_lives(TrackerState& state) const {
  for (csht::TargetTrack& track : state.tracks) {
    if (!track.used) continue;
    note_view(track, state);
    if (const char* reason = reason_to_end(track, state)) state.end(track, DecisionKind::end, reason);
  }
}

void Deletion::note_view(csht::TargetTrack& track, const TrackerState& state) const {
  if (track.detected_share > params_.in_view_share) track.last_detection_utime = state.now();
  const bool seen = track.visible_share >= params_.in_view_share;
  if (seen) track.in_view_utime = state.now();
  // Another sonar of the vehicle may have it in view.
  const csht::SensorLooks& looks = state.looks();
  const bool out = !seen && !(looks.several() && track.in_view_utime >= looks.oldest());
  if (!seen && !out) track.visible_share = 1.0;
  if (out != track.out_of_view && track.confirmed_once)
    state.decide(track, out ? DecisionKind::coast : DecisionKind::resume, track.log_odds,
                 out ? "left the field of view" : "back in the field of view");
  track.out_of_view = out;
  track.coasting = out && seconds_out_of_view(track, state) < params_.coast_s;
}

const char* Deletion::reason_to_end(const csht::TargetTrack& track, const TrackerState& state) const {
  const double least = track.confirmed_once ? params_.end_log_odds : tentative_log_odds_;
  if (track.log_odds < least) return "too little evidence left";
  if (!track.out_of_view) return nullptr;
  if (!track.confirmed_once) return "left the field of view unconfirmed";
  return seconds_out_of_view(track, state) >= std::max(params_.coast_s, params_.return_s)
             ? "out of view for too long"
             : nullptr;
}

}  // namespace lookout::tracking
