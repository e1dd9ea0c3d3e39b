#include "fusion/global_tracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parameter_check.hpp"

namespace lookout::fusion {
namespace {

constexpr double kLeastCoast = 1e-6;  // [s]; a coast of 0 ends a track at once.

}  // namespace

GlobalTracks::GlobalTracks(const GlobalTracksParams& params)
    : params_(params), pairings_(params.probation), credit_(params.credit, params.local_trust) {
  core::require(params.birth_estimates >= 1, "birth_estimates must be >= 1", params.birth_estimates);
  core::require_not_negative("coast", params.coast);
  core::require_inner_share("local_trust", params.local_trust);
  core::require_share("merge_threshold", params.merge_threshold);
  core::require_not_negative("process_noise", params.process_noise);
  core::require(params.merge_updates >= 1, "merge_updates must be >= 1", params.merge_updates);
  core::require(params.probation >= 1, "probation must be >= 1", params.probation);
}

void GlobalTracks::clear() {
  tracks_.clear();
  predicted_.clear();
  supports_.clear();
  supported_utime_.clear();
  voices_.clear();
  listeners_.clear();
  founders_.clear();
  credit_.forget_unproved();
  alike_.clear();
  merged_.clear();
  pairings_.clear();
}

void GlobalTracks::predict(std::int64_t utime) {
  const double dt = core::seconds(utime - utime_);
  utime_ = utime;
  const Eigen::Matrix4d F = core::constant_velocity_transition(dt);
  for (std::size_t g = 0; g < tracks_.size(); ++g) {
    Eigen::Matrix4d& covariance = tracks_[g].covariance;
    covariance =
        (F * covariance * F.transpose()).eval() + core::white_acceleration_noise(dt, params_.process_noise);
    TrackGroup& support = supports_[g];
    support.utime = utime;
    support.previous = tracks_[g].state;
    support.predicted = core::moved(support.previous, dt);
    support.is_new = false;
    voices_[g].clear();
    for (const Contribution& voice : support.contributions)
      voices_[g].push_back(
          {voice.track->key(), core::moved(voice.current, dt), pairings_.trusted_in(*voice.track) >= 0});
    support.contributions.clear();
    listeners_[g].clear();
    predicted_[g] = support.predicted;
  }
}

void GlobalTracks::start(const Contribution& contribution) {
  core::Track track;
  track.id = next_id_++;
  track.state = contribution.current;
  track.first_utime = utime_;
  tracks_.push_back(track);
  predicted_.push_back(track.state);
  supports_.push_back({track.id, utime_, true, track.state, track.state, {}});
  supported_utime_.push_back(utime_);
  voices_.emplace_back();
  listeners_.emplace_back();
  founders_.push_back({contribution.track->newest().node_id, false});
  credit_.note_begun(founders_.back().node_id);
  support(contribution, tracks_.size() - 1);
}

void GlobalTracks::support(const Contribution& contribution, std::size_t index) {
  const LocalTrack& local = *contribution.track;
  if (pairings_.pair(local, tracks_[index].id, company_of(index, local.newest().node_id))) {
    supports_[index].contributions.push_back(contribution);
  } else {
    listeners_[index].push_back(local.newest().node_id);
  }
}

Company GlobalTracks::company_of(std::size_t index, std::int32_t node_id) const {
  const auto before = [&](const Voice& voice) { return voice.key.first != node_id; };
  const auto now = [&](const Contribution& voice) { return voice.track->newest().node_id != node_id; };
  const auto& contributions = supports_[index].contributions;
  if (std::any_of(voices_[index].begin(), voices_[index].end(), before)) return Company::voices;
  if (std::any_of(contributions.begin(), contributions.end(), now)) return Company::newcomers;
  return Company::none;
}

std::span<const Eigen::Vector4d> GlobalTracks::predicted_for(std::int32_t node_id) {
  predicted_for_ = predicted_;
  for (std::size_t g = 0; g < voices_.size(); ++g) {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    int others = 0;
    bool is_guest = false;
    for (const Voice& voice : voices_[g]) {
      const bool is_own = voice.key.first == node_id;
      is_guest = is_guest || (is_own && !voice.trusted);
      if (is_own) continue;
      sum += voice.state;
      ++others;
    }
    if (is_guest && others > 0) predicted_for_[g] = sum / others;
  }
  return predicted_for_;
}

int GlobalTracks::place_of(std::int64_t global_id) const {
  const auto track = std::lower_bound(tracks_.begin(), tracks_.end(), global_id,
                                      [](const core::Track& t, std::int64_t id) { return t.id < id; });
  if (track == tracks_.end() || track->id != global_id) return -1;
  return static_cast<int>(track - tracks_.begin());
}

int GlobalTracks::supported_by(const LocalTrackStore::Key& local) const {
  return place_of(pairings_.global_of(local));
}

PastSupport GlobalTracks::past_of(const LocalTrack& local) const {
  const int place = place_of(pairings_.trusted_in(local));
  if (place < 0) return {};
  const Voices& voices = voices_[static_cast<std::size_t>(place)];
  return {place, voices.size() == 1 && voices.front().key == local.key()};
}

double GlobalTracks::nearest_of_others(const Eigen::Vector2d& position, std::int32_t node_id,
                                       std::int64_t utime) const {
  const double dt = core::seconds(utime - utime_);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < tracks_.size(); ++g) {
    const auto& voices = supports_[g].contributions;
    const auto is_other = [&](const Contribution& voice) { return voice.track->newest().node_id != node_id; };
    if (std::none_of(voices.begin(), voices.end(), is_other)) continue;
    nearest = std::min(nearest, (core::moved(tracks_[g].state, dt).head<2>() - position).norm());
  }
  return nearest;
}

void GlobalTracks::forget_locals(const LocalTrackStore::Tracks& known) {
  pairings_.forget_unknown(known);
}

void GlobalTracks::add_support(std::span<const Contribution> contributions, std::span<const int> indices) {
  for (std::size_t i = 0; i < contributions.size(); ++i) {
    const LocalTrack& local = *contributions[i].track;
    if (indices[i] >= 0)
      support(contributions[i], static_cast<std::size_t>(indices[i]));
    else if (local.heard() < static_cast<std::size_t>(params_.birth_estimates))
      continue;
    else if (credit_.may_begin(local.newest().node_id, local.life()))
      start(contributions[i]);
    else
      ++refused_births_;
  }
}

std::span<const TrackGroup> GlobalTracks::groups() {
  groups_.clear();
  for (const TrackGroup& support : supports_) {
    if (!support.contributions.empty()) groups_.push_back(support);
  }
  return groups_;
}

void GlobalTracks::take(std::span<const FusedState> fused, const TrackAssociation& likeness) {
  std::size_t next = 0;
  for (std::size_t g = 0; g < tracks_.size(); ++g) {
    if (supports_[g].contributions.empty()) {
      tracks_[g].state = predicted_[g];
    } else {
      tracks_[g].state = fused[next].state;
      tracks_[g].covariance = fused[next].covariance;
      ++next;
    }
    update_status(g);
  }
  merge_alike(likeness);
  const std::vector<bool> dead = ended();
  note_ends(dead);
  erase_where(dead);
}

void GlobalTracks::note_ends(const std::vector<bool>& dead) {
  for (std::size_t g = 0; g < dead.size(); ++g)
    if (dead[g] && !founders_[g].is_proved) credit_.note_false(founders_[g].node_id);
}

void GlobalTracks::update_status(std::size_t index) {
  core::Track& track = tracks_[index];
  const auto& contributions = supports_[index].contributions;
  if (contributions.empty()) {
    const double silence = core::seconds(utime_ - supported_utime_[index]);
    track.status = core::TrackStatus::coasting;
    track.existence =
        params_.local_trust * std::max(0.0, 1.0 - silence / std::max(params_.coast, kLeastCoast));
    return;
  }
  supported_utime_[index] = utime_;
  track.status = core::TrackStatus::confirmed;
  track.existence = 1.0 - doubt(index);
  look_for_proof(index);
  for (const Contribution& contribution : contributions)
    track.last_detection_utime = std::max(track.last_detection_utime, contribution.track->newest().utime);
}

/// Probability that all who speak for a track are wrong.
double GlobalTracks::doubt(std::size_t index) const {
  double doubt = 1.0;
  for (const Contribution& voice : supports_[index].contributions)
    doubt *= 1.0 - credit_.of(voice.track->newest().node_id);
  return doubt;
}

/// A track is proved when another node speaks for it too, or when it has gone on for long.
void GlobalTracks::look_for_proof(std::size_t index) {
  Founder& founder = founders_[index];
  if (founder.is_proved) return;
  const auto is_other = [&founder](const Contribution& voice) {
    return voice.track->newest().node_id != founder.node_id;
  };
  const auto& voices = supports_[index].contributions;
  const double life = core::seconds(utime_ - tracks_[index].first_utime);
  const auto has_lasted = [this](const Contribution& voice) {
    return voice.track->life() >= credit_.proof();
  };
  founder.is_proved = life >= credit_.proof() || std::any_of(voices.begin(), voices.end(), is_other) ||
                      std::any_of(voices.begin(), voices.end(), has_lasted);
  if (founder.is_proved) credit_.note_proved(founder.node_id);
}

std::vector<std::int32_t> GlobalTracks::nodes_of(std::size_t index) const {
  std::vector<std::int32_t> nodes = listeners_[index];
  for (const Contribution& voice : supports_[index].contributions)
    nodes.push_back(voice.track->newest().node_id);
  return nodes;
}

bool GlobalTracks::may_be_one(std::size_t a, std::size_t b) const {
  if (supports_[a].contributions.empty() || supports_[b].contributions.empty()) return false;
  // Two tracks that one node tells apart are two.
  const std::vector<std::int32_t> nodes = nodes_of(a), others = nodes_of(b);
  return std::find_first_of(nodes.begin(), nodes.end(), others.begin(), others.end()) == nodes.end();
}

void GlobalTracks::merge_alike(const TrackAssociation& likeness) {
  merged_.clear();
  std::map<IdPair, int> alike;
  std::vector<bool> dead(tracks_.size(), false);
  for (std::size_t a = 0; a < tracks_.size(); ++a) {
    for (std::size_t b = a + 1; b < tracks_.size(); ++b) {
      if (dead[a] || dead[b] || !may_be_one(a, b)) continue;
      if (likeness.membership(tracks_[a].state, tracks_[b].state) < params_.merge_threshold) continue;
      const IdPair pair{tracks_[a].id, tracks_[b].id};
      const auto before = alike_.find(pair);
      alike[pair] = before == alike_.end() ? 1 : before->second + 1;
      if (alike[pair] < params_.merge_updates) continue;
      // The number that more nodes go by stays; the older where they are as many.
      const bool keeps_older = nodes_of(a).size() >= nodes_of(b).size();
      const auto [ended, kept] = keeps_older ? IdPair{pair.second, pair.first} : pair;
      const std::size_t gone = keeps_older ? b : a;
      dead[gone] = true;
      if (!founders_[gone].is_proved) credit_.note_undecided(founders_[gone].node_id);
      merged_.push_back({ended, kept});
      pairings_.rename(ended, kept);
    }
  }
  alike_ = std::move(alike);
  erase_where(dead);
}

std::vector<bool> GlobalTracks::ended() const {
  std::vector<bool> dead(tracks_.size());
  for (std::size_t g = 0; g < tracks_.size(); ++g) {
    const double silence = core::seconds(utime_ - supported_utime_[g]);
    const double life = core::seconds(supported_utime_[g] - tracks_[g].first_utime);
    dead[g] = silence > std::min(params_.coast, life);
  }
  return dead;
}

void GlobalTracks::erase_where(const std::vector<bool>& dead) {
  std::size_t kept = 0;
  for (std::size_t g = 0; g < tracks_.size(); ++g) {
    if (dead[g]) continue;
    if (kept != g) {
      tracks_[kept] = tracks_[g];
      predicted_[kept] = predicted_[g];
      supports_[kept] = std::move(supports_[g]);
      supported_utime_[kept] = supported_utime_[g];
      voices_[kept] = std::move(voices_[g]);
      listeners_[kept] = std::move(listeners_[g]);
      founders_[kept] = founders_[g];
    }
    ++kept;
  }
  tracks_.resize(kept);
  predicted_.resize(kept);
  supports_.resize(kept);
  supported_utime_.resize(kept);
  voices_.resize(kept);
  listeners_.resize(kept);
  founders_.resize(kept);
}

}  // namespace lookout::fusion
