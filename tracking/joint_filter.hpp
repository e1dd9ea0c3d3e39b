#pragma once

#include "tracking/joint_manoeuvre.hpp"
#include "tracking/joint_memory.hpp"
#include "tracking/joint_observer.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/joint_state.hpp"

namespace lookout::tracking {

/// Takes a scan into the tracks that are there: weights and odds, fresh clouds, motion models, claims.
class JointFilter {
 public:
  /// @param params validated.
  explicit JointFilter(const JointTrackerParams& params);

  /// Moves all tracks on to the newest scan, `seconds` after the one before.
  void predict(double seconds, JointState& state) const;

  /// Updates all tracks with the newest scan.
  void update(JointState& state);

 private:
  void claim_provisionally(JointState& state);
  void take_scan(JointTrack& track, JointState& state);
  void refresh(JointTrack& track, JointState& state);
  bool tells_odds(const JointTrack& track, const AgeSpan& ages, const SamplingResult& result,
                  const JointState& state) const;
  void judge_motion(JointTrack& track, JointState& state);
  void estimate_odds(double life_evidence, JointTrack& track) const;
  void change_model(const JointManoeuvre::Judgement& judgement, JointTrack& track,
                    const JointState& state) const;
  void tell_change(const JointManoeuvre::Judgement& judgement, const JointTrack& track,
                   const JointState& state) const;

  JointCloudParams cloud_;
  JointLifeParams life_;
  JointMemory memory_;
  JointManoeuvre manoeuvre_;
  JointObserver observer_;
};

}  // namespace lookout::tracking
