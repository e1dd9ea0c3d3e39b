#pragma once

#include "csht/joint/joint_scene.hpp"
#include "tracking/decision.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/retrodiction.hpp"

namespace lookout::tracking {

/// What the steps of the joint tracker hand from one to the next: the engine's scene, what ended, and who is
/// told of decisions.
class TrackerState : public csht::JointScene {
 public:
  /// @param params validated. @param seed of all draws; those of a scan derive from (seed, sequence) alone.
  TrackerState(const JointTrackerParams& params, const core::SonarParams& sonar, std::uint64_t seed)
      : JointScene(params, sonar, {seed, core::RandomStream::tracker}),
        settled_log_odds_(params.hypotheses.settled_log_odds) {}

  Retrodiction retrodiction;
  DecisionLog log;

  /// Ends a track: frees its slot and takes back what it claimed.
  void end(csht::TargetTrack& track, DecisionKind kind, const char* reason);

  void decide(const csht::TargetTrack& track, DecisionKind kind, double evidence, const char* reason) const;

 private:
  double settled_log_odds_;
};

}  // namespace lookout::tracking
