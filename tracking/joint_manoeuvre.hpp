#pragma once

#include "core/random.hpp"
#include "tracking/joint_likelihood.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/joint_sampler.hpp"
#include "tracking/joint_track.hpp"

namespace lookout::tracking {

/// Two motion models a track: a straight line with the long memory, and a constant acceleration over the last
/// seconds alone, which a slow turn is too. Each is held against the other on the latest scans.
class JointManoeuvre {
 public:
  JointManoeuvre(const JointManoeuvreParams& params, int trajectories)
      : params_(params), trajectories_(trajectories) {}

  enum class Verdict { keep, curve, straighten };
  struct Judgement {
    Verdict verdict = Verdict::keep;
    double evidence = 0.0;  ///< In favour of the change [nats].
    int oldest = 0;         ///< Age from which the new model holds.
  };

  /// Judges a track after its update; where the model changes, `cloud` holds its trajectories.
  Judgement judge(int slot, const JointTrack& track, JointLikelihood& likelihood, JointSampler& sampler,
                  core::Random& random, JointCloud& cloud) const;

 private:
  Judgement leave_line(int slot, const JointTrack& track, JointLikelihood& likelihood, JointSampler& sampler,
                       core::Random& random, JointCloud& cloud) const;
  Judgement leave_curve(int slot, const JointTrack& track, JointLikelihood& likelihood, JointSampler& sampler,
                        core::Random& random, JointCloud& cloud) const;
  bool doubtful(const RecentEvidence& recent, int scans) const;
  SamplingTask task(int slot, const JointTrack& track, int oldest, bool curved) const;

  JointManoeuvreParams params_;
  int trajectories_;
};

}  // namespace lookout::tracking
