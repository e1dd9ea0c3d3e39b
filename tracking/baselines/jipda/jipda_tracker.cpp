#include "tracking/baselines/jipda/jipda_tracker.hpp"

#include "core/parameter_check.hpp"
#include "tracking/baselines/gaussian/twins.hpp"

namespace lookout::tracking {

void JipdaParams::validate() const {
  existence.validate();
  core::require(most_events >= 1.0, "most_events must be >= 1", most_events);
  core::require_not_negative("twin_distance", twin_distance);
}

JipdaTracker::JipdaTracker(const JipdaParams& params, const core::SonarParams& sonar)
    : params_(params),
      motion_(params.motion, sonar),
      scene_(params.view, params.population, sonar),
      update_(params.most_events) {
  params_.validate();
}

std::span<const core::Track> JipdaTracker::update(const core::PosedScan& scan,
                                                  std::span<const core::MotionElement> /*elements*/) {
  scene_.look(scan);
  predict();
  associate();
  drop_twins();
  step_lives();
  learn();
  begin();
  return report();
}

void JipdaTracker::predict() {
  for (auto& track : tracks_) {
    motion_.predict(track.target, scene_.seconds());
    track.existence *= scene_.survival();
    track.spread = scene_.view().spread_of(track.target);
    scene_.view().claim(track.spread, {track.target, track.existence});
  }
}

void JipdaTracker::associate() {
  free_.assign(scene_.view().returns().size(), 1.0);
  update_.update(tracks_, scene_, free_);
}

void JipdaTracker::drop_twins() {
  const std::vector<char> dropped = find_twins(tracks_, params_.twin_distance);
  decisions_.merged(tracks_, dropped, scene_.utime());
  drop(tracks_, dropped);
}

void JipdaTracker::step_lives() {
  std::size_t kept = 0;
  for (auto& track : tracks_)
    if (decisions_.step(track, params_.existence, scene_)) tracks_[kept++] = track;
  tracks_.resize(kept);
}

void JipdaTracker::learn() {
  scene_.finish(tally_of(tracks_, scene_.view()));
}

void JipdaTracker::begin() {
  const auto& returns = scene_.view().returns();
  for (std::size_t j = 0; j < returns.size(); ++j) {
    const double existence = scene_.birth_existence(returns[j], update_.unclaimed(j));
    if (existence < params_.existence.forget) continue;
    BernoulliTrack track;
    track.id = next_id_++;
    track.target = motion_.born(returns[j].measurement);
    track.existence = existence;
    track.first_utime = track.last_detection_utime = scene_.utime();
    tracks_.push_back(track);
    decisions_.began(track);
  }
}

std::span<const core::Track> JipdaTracker::report() {
  reported_.clear();
  for (const auto& track : tracks_) reported_.push_back(to_track(track));
  return reported_;
}

}  // namespace lookout::tracking
