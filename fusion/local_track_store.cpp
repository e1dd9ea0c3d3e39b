#include "fusion/local_track_store.hpp"

#include <algorithm>

#include "core/parameter_check.hpp"

namespace lookout::fusion {
namespace {

/// Share of a new interval in the running mean: the last ten or so count.
constexpr double kRhythmGain = 0.1;

}  // namespace

LocalTrackStore::LocalTrackStore(const LocalTrackStoreParams& params) : params_(params) {
  core::require_positive("max_gap", params.max_gap);
  core::require_positive("max_age", params.max_age);
  core::require_positive("min_silence", params.min_silence);
  core::require(params.silent_rounds > 1.0, "silent_rounds must be > 1", params.silent_rounds);
  core::require(params.skips >= 1 && params.skips < static_cast<int>(LocalTrack::kMemory),
                "skips must be 1 to 7", params.skips);
  core::require(params.forget_after >= params.max_age, "forget_after must be >= max_age",
                params.forget_after);
  core::require(params.max_tracks >= 1, "max_tracks must be >= 1", static_cast<double>(params.max_tracks));
}

Intake LocalTrackStore::add(const LocalEstimate& estimate) {
  const Key key{estimate.node_id, estimate.track_id};
  const auto found = tracks_.find(key);
  if (found == tracks_.end()) {
    if (tracks_.size() >= params_.max_tracks) return Intake::too_many;
    tracks_.emplace(key, LocalTrack(estimate));
    return Intake::accepted;
  }
  LocalTrack& track = found->second;
  const double gap = core::seconds(estimate.utime - track.newest().utime);
  if (gap == 0.0) return Intake::duplicate;
  if (gap < 0.0) return Intake::out_of_order;
  track.append(estimate);
  if (gap > params_.max_gap) {
    track.restart();
  } else {
    Rhythm& rhythm = rhythms_[estimate.node_id];
    rhythm.interval += (rhythm.interval > 0.0 ? kRhythmGain : 1.0) * (gap - rhythm.interval);
    note_turn(track);
  }
  return Intake::accepted;
}

void LocalTrackStore::note_turn(const LocalTrack& track) {
  // A track in turn is heard once between two estimates of this one.
  const auto skips = static_cast<std::size_t>(params_.skips);
  if (track.size() <= skips) return;
  Rhythm& rhythm = rhythms_[track.newest().node_id];
  rhythm.skipped_before = std::max(rhythm.skipped_before, track.back(skips).utime);
}

double LocalTrackStore::silence_limit(std::int32_t node_id) const {
  const auto rhythm = rhythms_.find(node_id);
  const double expected = rhythm == rhythms_.end() ? params_.max_age : rhythm->second.interval;
  return std::min(params_.max_age, std::max(params_.min_silence, params_.silent_rounds * expected));
}

bool LocalTrackStore::votes(const LocalTrack& track, std::int64_t utime) const {
  const std::int32_t node_id = track.newest().node_id;
  const auto rhythm = rhythms_.find(node_id);
  const bool skipped = rhythm != rhythms_.end() && track.newest().utime < rhythm->second.skipped_before;
  return track.is_tracklet() && !skipped && track.age(utime) <= silence_limit(node_id);
}

void LocalTrackStore::forget_silent(std::int64_t utime) {
  std::erase_if(tracks_, [&](const auto& entry) { return entry.second.age(utime) > params_.forget_after; });
}

void LocalTrackStore::clear() {
  tracks_.clear();
  rhythms_.clear();
}

}  // namespace lookout::fusion
