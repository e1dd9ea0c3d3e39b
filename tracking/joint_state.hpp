#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "tracking/decision.hpp"
#include "tracking/joint_likelihood.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/joint_retrodiction.hpp"
#include "tracking/joint_sampler.hpp"
#include "tracking/joint_track.hpp"

namespace lookout::tracking {

/// What the steps of the joint tracker hand from one to the next: the scans, the tracks and the tools to
/// sample them.
class JointState {
 public:
  /// @param params validated. @param seed of all draws; those of a scan derive from (seed, sequence) alone.
  JointState(const JointTrackerParams& params, const core::SonarParams& sonar, std::uint64_t seed);

  JointPrior prior;
  core::Random random;
  JointLikelihood likelihood;
  JointSampler sampler;
  JointCloud fresh;                ///< Where a cloud is drawn before it replaces another.
  std::vector<JointTrack> tracks;  ///< Slots, used again when free.
  JointRetrodiction retrodiction;
  DecisionLog log;

  const csht::ScanHistory& scans() const { return likelihood.scans(); }
  std::int64_t now() const { return scans().newest().utime; }

  /// A slot that is free, with a new identity; null when `max_tracks` are alive. The caller fills it and sets
  /// `used`.
  JointTrack* free_track();
  int slot_of(const JointTrack& track) const { return static_cast<int>(&track - tracks.data()); }

  /// Ends a track: frees its slot and takes back what it claimed.
  void end(JointTrack& track, DecisionKind kind, const char* reason);

  void decide(const JointTrack& track, DecisionKind kind, double evidence, const char* reason) const;

 private:
  std::size_t max_tracks_;
  double settled_log_odds_;
  std::int64_t last_id_ = 0;
};

}  // namespace lookout::tracking
