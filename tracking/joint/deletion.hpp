#pragma once

#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

/// Deletes tracks: twins, those that lost their evidence, and those that are out of view for too long.
class Deletion {
 public:
  /// @param params validated.
  explicit Deletion(const JointTrackerParams& params)
      : params_(params.life), tentative_log_odds_(params.hypotheses.tentative_log_odds) {}

  /// Of two tracks on one target (twins) deletes the one that was never confirmed, else the less probable.
  void end_twins(TrackerState& state) const;

  /// Notes which tracks are in view and which coast, then deletes those without enough evidence and those
  /// that are out of view for too long.
  void end_lives(TrackerState& state) const;

 private:
  void note_view(csht::TargetTrack& track, const TrackerState& state) const;
  bool twins(const csht::TargetTrack& a, const csht::TargetTrack& b) const;
  const char* reason_to_end(const csht::TargetTrack& track, const TrackerState& state) const;

  LifeParams params_;
  double tentative_log_odds_;
};

}  // namespace lookout::tracking
