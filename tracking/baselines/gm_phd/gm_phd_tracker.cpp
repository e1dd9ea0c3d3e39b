#include "tracking/baselines/gm_phd/gm_phd_tracker.hpp"

#include <algorithm>

namespace lookout::tracking {

void GmPhdParams::validate() const {
  existence.validate();
}

GmPhdTracker::GmPhdTracker(const GmPhdParams& params, const core::SonarParams& sonar)
    : params_(params),
      motion_(params.motion, sonar),
      scene_(params.view, params.population, sonar),
      intensity_(params.intensity) {
  params_.validate();
}

std::span<const core::Track> GmPhdTracker::update(const core::PosedScan& scan,
                                                  std::span<const core::MotionElement> /*elements*/) {
  scene_.look(scan);
  intensity_.predict(motion_, scene_);
  intensity_.update(scene_, motion_, next_id_);
  follow_labels();
  step_lives();
  scene_.finish(tally_of(tracks_, scene_.view()));
  return report();
}

/// One track a label: those that were there go on, new ones begin, those without components end.
void GmPhdTracker::follow_labels() {
  before_.swap(tracks_);
  tracks_.clear();
  auto old = before_.begin();
  for (const auto& label : intensity_.labels()) {
    for (; old != before_.end() && old->id < label.label; ++old) tell_lost(*old);
    const bool is_new = old == before_.end() || old->id != label.label;
    tracks_.push_back(is_new ? BernoulliTrack{} : *old++);
    follow(tracks_.back(), label);
    if (is_new) begin(tracks_.back());
  }
  for (; old != before_.end(); ++old) tell_lost(*old);
}

void GmPhdTracker::begin(BernoulliTrack& track) {
  track.first_utime = track.last_detection_utime = scene_.utime();
  decisions_.began(track);
}

void GmPhdTracker::tell_lost(const BernoulliTrack& track) const {
  decisions_.ended(track, scene_.utime(), "its weight fell to nothing, or went to another label");
}

void GmPhdTracker::follow(BernoulliTrack& track, const LabelSum& label) {
  constexpr double kHalf = 0.5;
  track.id = label.label;
  track.target = label.target;
  track.existence = std::min(1.0, label.weight);
  track.detected = std::min(1.0, label.detected);
  track.spread = scene_.view().spread_of(track.target);
  if (track.detected > kHalf) track.last_detection_utime = scene_.utime();
}

void GmPhdTracker::step_lives() {
  std::size_t kept = 0;
  for (auto& track : tracks_) {
    if (decisions_.step(track, params_.existence, scene_))
      tracks_[kept++] = track;
    else
      intensity_.forget(track.id);
  }
  tracks_.resize(kept);
}

std::span<const core::Track> GmPhdTracker::report() {
  reported_.clear();
  for (const auto& track : tracks_) reported_.push_back(to_track(track));
  return reported_;
}

}  // namespace lookout::tracking
