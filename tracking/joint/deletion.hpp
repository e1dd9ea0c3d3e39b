#pragma once

#include "tracking/joint/joint_params.hpp"
#include "tracking/joint/tracker_state.hpp"

namespace lookout::tracking {

/// Ends tracks: twins, those that lost their evidence, and those out of view for too long.
class Deletion {
 public:
  /// @param params validated.
  explicit Deletion(const JointTrackerParams& params)
      : params_(params.life), tentative_log_odds_(params.hypotheses.tentative_log_odds) {}

  /// Of two tracks that are on one target the less probable ends.
  void end_twins(TrackerState& state) const;

  /// Notes who is in view, and ends those whose time has come.
  void end_lives(TrackerState& state) const;

 private:
  void note_view(csht::TargetTrack& track, const TrackerState& state) const;
  bool twins(const csht::TargetTrack& a, const csht::TargetTrack& b) const;
  const char* reason_to_end(const csht::TargetTrack& track, const TrackerState& state) const;

  LifeParams params_;
  double tentative_log_odds_;
};

}  // namespace lookout::tracking
