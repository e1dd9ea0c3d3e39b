#pragma once

#include "csht/joint/joint_scene.hpp"
#include "tracking/decision.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/retrodiction.hpp"

namespace lookout::tracking {

/// What the steps of the joint tracker work on: the engine's scene, the deleted tracks, and who is told of
/// decisions.
class TrackerState : public csht::JointScene {
 public:
  /// @param params validated. @param seed of all draws; those of a scan derive from (seed, sequence) alone.
  TrackerState(const JointTrackerParams& params, const core::SonarParams& sonar, std::uint64_t seed)
      : JointScene(params, sonar, {seed, core::RandomStream::tracker}),
        settled_log_odds_(params.hypotheses.settled_log_odds) {
    clutter.set_mean_life(params.life.mean_life_s);
  }

  Retrodiction retrodiction;  ///< Knows the tracks that were deleted.
  DecisionLog log;            ///< Is told of decisions; may be empty.

  /// Deletes a track: frees its slot and takes back its claims. Where it was confirmed, tells why.
  /// @param reason a static text.
  void end(csht::TargetTrack& track, DecisionKind kind, const char* reason);

  /// Tells `log` of a decision at the newest scan. @param evidence see TrackDecision.
  /// @param reason a static text.
  void decide(const csht::TargetTrack& track, DecisionKind kind, double evidence, const char* reason) const;

 private:
  double settled_log_odds_;
};

}  // namespace lookout::tracking
