#include "tracking/joint/tracker_state.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {
namespace {

int capacity_of(const JointTrackerParams& params, const core::SonarParams& sonar) {
  const double seconds = std::max(params.cloud.memory_s, params.birth.window_s);
  return 1 + static_cast<int>(std::ceil(seconds / sonar.scan_period));
}

csht::SensorModelParams model_of(const JointTrackerParams& params, const core::SonarParams& sonar) {
  csht::SensorModelParams model = params.sensor;
  model.clutter = csht::clutter_model_of(sonar);
  return model;
}

}  // namespace

TrackerState::TrackerState(const JointTrackerParams& params, const core::SonarParams& sonar,
                           std::uint64_t seed)
    : prior(params.prior, sonar.max_speed, sonar.scan_period),
      random(seed, core::RandomStream::tracker),
      likelihood(csht::figures_of(sonar), model_of(params, sonar), params.tolerance,
                 capacity_of(params, sonar), params.life.max_tracks, prior),
      sampler(params.cloud, prior, random),
      max_tracks_(static_cast<std::size_t>(params.life.max_tracks)),
      settled_log_odds_(params.life.settled_log_odds) {
  const auto largest = static_cast<std::size_t>(params.cloud.trajectories);
  fresh.reserve(largest);
  tracks.reserve(max_tracks_);
  tracks.resize(std::min(max_tracks_, static_cast<std::size_t>(params.life.ready_tracks)));
  for (csht::TargetTrack& track : tracks) {
    track.cloud.reserve(largest);
    track.log_ratio.reserve(largest);
  }
}

csht::TargetTrack* TrackerState::free_track() {
  auto free = std::find_if(tracks.begin(), tracks.end(), [](const csht::TargetTrack& t) { return !t.used; });
  if (free == tracks.end()) {
    if (tracks.size() == max_tracks_) return nullptr;
    tracks.emplace_back();
    free = tracks.end() - 1;
  }
  free->id = ++last_id_;
  return &*free;
}

void TrackerState::end(csht::TargetTrack& track, DecisionKind kind, const char* reason) {
  track.used = false;
  likelihood.set_existence(slot_of(track), 0.0);
  likelihood.forget_claims(slot_of(track));
  if (!track.confirmed_once) return;
  if (kind == DecisionKind::end) retrodiction.retire(track, now(), settled_log_odds_);
  decide(track, kind, track.log_odds, reason);
}

void TrackerState::decide(const csht::TargetTrack& track, DecisionKind kind, double evidence,
                          const char* reason) const {
  if (log) log({now(), track.id, kind, evidence, reason});
}

}  // namespace lookout::tracking
