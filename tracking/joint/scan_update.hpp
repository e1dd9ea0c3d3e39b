#pragma once

#include "csht/joint/evidence/beam_claims.hpp"
#include "csht/joint/evidence/memory_span.hpp"
#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/motion_change.hpp"
#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

/// Takes a scan into the tracks that are there: weights and odds, fresh clouds where few trajectories are
/// left, changes of motion, claims.
class ScanUpdate {
 public:
  /// @param params validated.
  explicit ScanUpdate(const JointTrackerParams& params);

  /// Moves all tracks on to the newest scan, `seconds` after the one before; each may have vanished meanwhile
  /// ([Ristic2013], the prediction of a Bernoulli filter).
  void predict(double seconds, TrackerState& state) const;

  /// Updates all tracks with the newest scan, each given what the others claim of it.
  void update(TrackerState& state);

 private:
  double excess_of_misses(const csht::TargetTrack& track, const TrackerState& state) const;
  void stray(double seconds, csht::TargetTrack& track, TrackerState& state) const;
  void claim_provisionally(TrackerState& state);
  void take_scan(csht::TargetTrack& track, TrackerState& state);
  void refresh(csht::TargetTrack& track, TrackerState& state);
  bool leads_away(const csht::TrajectoryCloud& drawn, const csht::TargetTrack& track,
                  const TrackerState& state) const;
  bool tells_odds(const csht::TargetTrack& track, const csht::AgeSpan& ages,
                  const csht::SamplingResult& result, const TrackerState& state) const;
  void judge_motion(csht::TargetTrack& track, TrackerState& state);
  void estimate_odds(double life_evidence, csht::TargetTrack& track) const;
  void change_model(const MotionChange::Judgement& judgement, csht::TargetTrack& track,
                    const TrackerState& state) const;
  void tell_change(const MotionChange::Judgement& judgement, const csht::TargetTrack& track,
                   const TrackerState& state) const;

  csht::TrajectoryCloudParams cloud_;
  LifeParams life_;
  double settled_log_odds_;
  csht::MemorySpan memory_;
  MotionChange manoeuvre_;
  csht::BeamClaims claims_;
};

}  // namespace lookout::tracking
