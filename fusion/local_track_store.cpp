#include "fusion/local_track_store.hpp"

#include <algorithm>
#include <limits>

#include "core/parameter_check.hpp"

namespace lookout::fusion {
namespace {

/// Share of a new interval in the running mean: the last ten or so count.
constexpr double kRhythmGain = 0.1;
/// Turns of a slow node that its track may wait, and after which it is forgotten.
constexpr double kTurnsOfVote = 1.5;
constexpr double kTurnsOfMemory = 3.0;

void blend(double& mean, double value) {
  mean += (mean > 0.0 ? kRhythmGain : 1.0) * (value - mean);
}

}  // namespace

LocalTrackStore::LocalTrackStore(const LocalTrackStoreParams& params) : params_(params) {
  core::require_positive("max_gap", params.max_gap);
  core::require_positive("max_age", params.max_age);
  core::require_positive("max_silence", params.max_silence);
  core::require(params.min_estimates == 1 || params.min_estimates == 2, "min_estimates must be 1 or 2",
                params.min_estimates);
  core::require_positive("min_silence", params.min_silence);
  core::require(params.silent_rounds > 1.0, "silent_rounds must be > 1", params.silent_rounds);
  core::require(params.skips >= 1 && params.skips < static_cast<int>(LocalTrack::kMemory),
                "skips must be 1 to 7", params.skips);
  core::require(params.forget_after >= params.max_age, "forget_after must be >= max_age",
                params.forget_after);
  core::require(params.max_tracks_of_node >= 1, "max_tracks_of_node must be >= 1",
                static_cast<double>(params.max_tracks_of_node));
  core::require(params.max_tracks >= 1, "max_tracks must be >= 1", static_cast<double>(params.max_tracks));
}

Intake LocalTrackStore::add(const LocalEstimate& estimate, std::int64_t arrived) {
  const Key key{estimate.node_id, estimate.track_id};
  const auto found = tracks_.find(key);
  if (found == tracks_.end()) {
    if (!has_room_for(estimate.node_id)) return Intake::too_many;
    ++rhythms_[estimate.node_id].known;
    tracks_.emplace(key, LocalTrack(estimate)).first->second.note_arrival(arrived);
    note_message(estimate);
    return Intake::accepted;
  }
  LocalTrack& track = found->second;
  const double gap = core::seconds(estimate.utime - track.newest().utime);
  if (gap == 0.0) return Intake::duplicate;
  if (gap < 0.0) return Intake::out_of_order;
  const bool goes_on = gap <= std::max(params_.max_gap, turn_limit(estimate.node_id));
  note_message(estimate);
  track.append(estimate, arrived);
  if (goes_on) {
    blend(rhythms_[estimate.node_id].interval, gap);
    note_turn(track);
  } else {
    track.restart();
  }
  return Intake::accepted;
}

/// No node takes the room of the others.
bool LocalTrackStore::has_room_for(std::int32_t node_id) const {
  const auto rhythm = rhythms_.find(node_id);
  return tracks_.size() < params_.max_tracks &&
         (rhythm == rhythms_.end() || rhythm->second.known < params_.max_tracks_of_node);
}

void LocalTrackStore::note_message(const LocalEstimate& estimate) {
  Rhythm& rhythm = rhythms_[estimate.node_id];
  const std::int64_t before = rhythm.newest_message.value_or(estimate.utime);
  if (estimate.utime > before) blend(rhythm.message_interval, core::seconds(estimate.utime - before));
  rhythm.newest_message = std::max(before, estimate.utime);
  rhythm.live = live_tracks(estimate.node_id);
}

double LocalTrackStore::live_tracks(std::int32_t node_id) const {
  double live = 0.0;
  const Key first{node_id, std::numeric_limits<std::int64_t>::min()};
  for (auto entry = tracks_.lower_bound(first); entry != tracks_.end() && entry->first.first == node_id;
       ++entry)
    live += is_skipped(entry->second) ? 0.0 : 1.0;
  return live;
}

void LocalTrackStore::note_turn(const LocalTrack& track) {
  // A track in turn is heard once between two estimates of this one.
  const auto skips = static_cast<std::size_t>(params_.skips);
  if (track.size() <= skips) return;
  Rhythm& rhythm = rhythms_[track.newest().node_id];
  rhythm.skipped_before = std::max(rhythm.skipped_before, track.back(skips).utime);
}

bool LocalTrackStore::is_skipped(const LocalTrack& track) const {
  const auto rhythm = rhythms_.find(track.newest().node_id);
  return rhythm != rhythms_.end() && track.newest().utime < rhythm->second.skipped_before;
}

/// How long a live track of the node may wait for its turn [s]: the node's interval for each of them.
double LocalTrackStore::turn_limit(std::int32_t node_id) const {
  const auto rhythm = rhythms_.find(node_id);
  if (rhythm == rhythms_.end()) return 0.0;
  return kTurnsOfVote * rhythm->second.live * rhythm->second.message_interval;
}

double LocalTrackStore::silence_limit(std::int32_t node_id) const {
  const auto rhythm = rhythms_.find(node_id);
  const bool is_known = rhythm != rhythms_.end() && rhythm->second.interval > 0.0;
  const double expected = is_known ? rhythm->second.interval : params_.max_silence;
  const double longest = std::max(params_.max_silence, turn_limit(node_id));
  return std::min(longest, std::max(params_.min_silence, params_.silent_rounds * expected));
}

bool LocalTrackStore::votes(const LocalTrack& track, std::int64_t utime) const {
  return track.heard() >= static_cast<std::size_t>(params_.min_estimates) && !is_skipped(track) &&
         track.age(utime) <= params_.max_age && track.silence(utime) <= silence_limit(track.newest().node_id);
}

void LocalTrackStore::forget_silent(std::int64_t utime) {
  std::erase_if(tracks_, [&](const auto& entry) {
    const double turn = kTurnsOfMemory / kTurnsOfVote * turn_limit(entry.first.first);
    const bool is_silent = entry.second.silence(utime) > std::max(params_.forget_after, turn);
    if (is_silent) --rhythms_[entry.first.first].known;
    return is_silent;
  });
  std::erase_if(rhythms_, [](const auto& entry) { return entry.second.known == 0; });
}

void LocalTrackStore::clear() {
  tracks_.clear();
  rhythms_.clear();
}

}  // namespace lookout::fusion
