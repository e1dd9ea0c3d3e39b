#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"
#include "csht/joint/evidence/trajectory_sampler.hpp"
#include "tracking/decision.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/retrodiction.hpp"

namespace lookout::tracking {

/// What the steps of the joint tracker hand from one to the next: the scans, the tracks and the tools to
/// sample them.
class TrackerState {
 public:
  /// @param params validated. @param seed of all draws; those of a scan derive from (seed, sequence) alone.
  TrackerState(const JointTrackerParams& params, const core::SonarParams& sonar, std::uint64_t seed);

  csht::TargetPrior prior;
  core::Random random;
  csht::ScanLikelihood likelihood;
  csht::TrajectorySampler sampler;
  csht::TrajectoryCloud fresh;            ///< Where a cloud is drawn before it replaces another.
  std::vector<csht::TargetTrack> tracks;  ///< Slots, used again when free.
  Retrodiction retrodiction;
  DecisionLog log;

  const csht::ScanHistory& scans() const { return likelihood.scans(); }
  std::int64_t now() const { return scans().newest().utime; }

  /// A slot that is free, with a new identity; null when `max_tracks` are alive. The caller fills it and sets
  /// `used`.
  csht::TargetTrack* free_track();
  int slot_of(const csht::TargetTrack& track) const { return static_cast<int>(&track - tracks.data()); }

  /// Ends a track: frees its slot and takes back what it claimed.
  void end(csht::TargetTrack& track, DecisionKind kind, const char* reason);

  void decide(const csht::TargetTrack& track, DecisionKind kind, double evidence, const char* reason) const;

 private:
  std::size_t max_tracks_;
  double settled_log_odds_;
  std::int64_t last_id_ = 0;
};

}  // namespace lookout::tracking
