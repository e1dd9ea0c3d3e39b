#include "tracking/baselines/gaussian/bernoulli_track.hpp"

#include <algorithm>

#include "tracking/baselines/gaussian/target_mixture.hpp"

namespace lookout::tracking {
namespace {

constexpr double kSure = 0.9;  // Existence of a target that teaches P_M, as csht::SensorFigureParams has it.

}  // namespace

core::Track to_track(const BernoulliTrack& track) {
  core::Track result;
  result.id = track.id;
  result.status = track.life.status();
  result.state = track.target.mean();
  result.covariance = track.target.covariance();
  result.existence = track.existence;
  result.first_utime = track.first_utime;
  result.last_detection_utime = track.last_detection_utime;
  return result;
}

ScanTally tally_of(std::span<const BernoulliTrack> tracks, const ScanView& view) {
  ScanTally tally;
  double owned = 0.0;
  for (const auto& track : tracks) {
    owned += track.detected;
    if (track.life.status() != core::TrackStatus::confirmed || track.existence < kSure) continue;
    tally.targets += track.existence * view.in_view(track.spread);
    tally.detected += track.detected;
  }
  tally.false_returns = static_cast<double>(view.returns().size()) - owned;
  tally.empty_beams = std::max(1.0, view.num_beams() - tally.targets);
  return tally;
}

void BernoulliUpdate::update(std::span<BernoulliTrack> tracks, const RivalScene& scene,
                             std::span<const double> free) {
  weigh(tracks, scene, free);
  marginals_.solve(pairs_, static_cast<int>(tracks.size()), static_cast<int>(free.size()));
  settle(tracks, scene);
}

void BernoulliUpdate::weigh(std::span<const BernoulliTrack> tracks, const RivalScene& scene,
                            std::span<const double> free) {
  const auto& returns = scene.view().returns();
  miss_ratio_.clear();
  missed_.clear();
  pairs_.clear();
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    miss_ratio_.push_back(scene.view().miss_ratio(tracks[i].spread, {tracks[i].target, tracks[i].existence}));
    missed_.push_back(1.0 - tracks[i].existence + tracks[i].existence * miss_ratio_[i]);
    for (std::size_t j = 0; j < returns.size(); ++j) {
      const double ratio = scene.view().return_ratio(tracks[i].target, returns[j]);
      if (ratio <= 0.0) continue;
      const double weight =
          tracks[i].existence * ratio * free[j] / (1.0 + scene.birth_ratio(returns[j])) / missed_[i];
      if (weight > 0.0) pairs_.push_back({static_cast<int>(i), static_cast<int>(j), weight});
    }
  }
}

void BernoulliUpdate::settle(std::span<BernoulliTrack> tracks, const RivalScene& scene) {
  std::size_t pair = 0;
  for (std::size_t i = 0; i < tracks.size(); ++i) pair = settle(i, pair, tracks[i], scene);
}

// The mixture over what the track may have, of those cases in which it exists. @return the next track's pair.
std::size_t BernoulliUpdate::settle(std::size_t index, std::size_t pair, BernoulliTrack& track,
                                    const RivalScene& scene) {
  const double there = track.existence * miss_ratio_[index] / missed_[index];
  TargetMixture mixture(track.target);
  mixture.add(marginals_.missed(static_cast<int>(index)) * there, track.target);
  track.detected = 0.0;
  for (; pair < pairs_.size() && pairs_[pair].track == static_cast<int>(index); ++pair) {
    const auto& seen = scene.view().returns()[static_cast<std::size_t>(pairs_[pair].detection)];
    mixture.add(marginals_.pair(pair), updated(track.target, seen.measurement));
    track.detected += marginals_.pair(pair);
  }
  track.existence = mixture.weight();
  if (track.existence > 0.0) track.target = mixture.merged();
  if (track.detected > 0.5) track.last_detection_utime = scene.utime();
  return pair;
}

}  // namespace lookout::tracking
