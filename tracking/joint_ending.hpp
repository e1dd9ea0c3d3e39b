#pragma once

#include "tracking/joint_params.hpp"
#include "tracking/joint_state.hpp"

namespace lookout::tracking {

/// Ends tracks: twins, those that lost their evidence, and those out of view for too long.
class JointEnding {
 public:
  /// @param params validated.
  explicit JointEnding(const JointLifeParams& params) : params_(params) {}

  /// Of two tracks that are on one target the less probable ends.
  void end_twins(JointState& state) const;

  /// Notes who is in view, and ends those whose time has come.
  void end_lives(JointState& state) const;

 private:
  void note_view(JointTrack& track, const JointState& state) const;
  bool twins(const JointTrack& a, const JointTrack& b) const;
  const char* reason_to_end(const JointTrack& track, const JointState& state) const;

  JointLifeParams params_;
};

}  // namespace lookout::tracking
