#include "tracking/baselines/gaussian/bernoulli_decisions.hpp"

#include "tracking/management/life_decision.hpp"

namespace lookout::tracking {
namespace {

constexpr const char* kImprobable = "no longer probable";

/// @param improbable whether a track outside the field of view ends for that, and not for its time there.
LifeReasons reasons(bool improbable) {
  return {.confirm = "probable enough",
          .forget = "too improbable to go on with",
          .end = kImprobable,
          .lose = improbable ? kImprobable : "outside the field of view for too long"};
}

}  // namespace

void BernoulliDecisions::step(BernoulliTrack& track, const ExistenceParams& params, std::int64_t utime,
                              bool in_view) const {
  const core::TrackStatus before = track.life.status();
  track.life.step(params, {utime, track.existence, in_view});
  const auto decision = decided({before, track.life.status(), in_view, track.life.ended()},
                                reasons(track.existence < params.end));
  if (decision) tell(track, utime, decision->kind, decision->reason);
}

bool BernoulliDecisions::step(BernoulliTrack& track, const ExistenceParams& params,
                              const RivalScene& scene) const {
  constexpr double kHalf = 0.5;
  const bool in_view = scene.view().in_view(scene.view().spread_of(track.target)) >= kHalf;
  step(track, params, scene.utime(), in_view);
  return !track.life.ended();
}

void BernoulliDecisions::began(const BernoulliTrack& track) const {
  tell(track, track.first_utime, DecisionKind::begin, "a return that may be nobody else's");
}

void BernoulliDecisions::merged(std::span<const BernoulliTrack> tracks, const std::vector<char>& dropped,
                                std::int64_t utime) const {
  for (std::size_t i = 0; i < tracks.size(); ++i)
    if (dropped[i])
      tell(tracks[i], utime, DecisionKind::merge, "a more probable track follows the same target");
}

void BernoulliDecisions::ended(const BernoulliTrack& track, std::int64_t utime, const char* reason) const {
  tell(track, utime, DecisionKind::end, reason);
}

void BernoulliDecisions::tell(const BernoulliTrack& track, std::int64_t utime, DecisionKind kind,
                              const char* reason) const {
  if (log_) log_({utime, track.id, kind, log_odds(track.existence), reason});
}

}  // namespace lookout::tracking
