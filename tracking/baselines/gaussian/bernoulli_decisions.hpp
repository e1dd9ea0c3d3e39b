#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracking/baselines/gaussian/bernoulli_track.hpp"
#include "tracking/decision.hpp"

namespace lookout::tracking {

/// What is decided about the tracks of a rival, and tells it: each by its existence.
class BernoulliDecisions {
 public:
  /// Sends every decision from now on to `log`.
  void tell_to(const DecisionLog& log) { log_ = log; }

  /// Takes a scan at `utime` [us] into a track's life. @param in_view whether the sonar could see it.
  void step(BernoulliTrack& track, const ExistenceParams& params, std::int64_t utime, bool in_view) const;

  /// Takes the newest scan into a track's life; seen is what is in view more probably than not.
  /// @return whether the track goes on.
  bool step(BernoulliTrack& track, const ExistenceParams& params, const RivalScene& scene) const;

  /// A track began on a return at its `first_utime`.
  void began(const BernoulliTrack& track) const;
  /// Tracks with a flag end at `utime` [us], for they follow another's target. @param dropped one a track.
  void merged(std::span<const BernoulliTrack> tracks, const std::vector<char>& dropped,
              std::int64_t utime) const;
  /// A track ended at `utime` [us] for a `reason` of the tracker's own, a static text.
  void ended(const BernoulliTrack& track, std::int64_t utime, const char* reason) const;

 private:
  void tell(const BernoulliTrack& track, std::int64_t utime, DecisionKind kind, const char* reason) const;

  DecisionLog log_;
};

}  // namespace lookout::tracking
