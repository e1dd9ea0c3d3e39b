#pragma once

#include "core/random.hpp"
#include "tracking/joint_likelihood.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/joint_sampler.hpp"
#include "tracking/joint_track.hpp"

namespace lookout::tracking {

/// Two motion models a track: a straight line with the long memory, and a constant acceleration over the last
/// seconds alone, which a slow turn is too. Each is held against the other on the latest scans. A young track
/// that fits poorly may also be on the wrong line: that is tried first.
class JointManoeuvre {
 public:
  JointManoeuvre(const JointManoeuvreParams& params, int trajectories)
      : params_(params), trajectories_(trajectories) {}

  enum class Verdict { keep, curve, straighten, redraw };
  struct Judgement {
    Verdict verdict = Verdict::keep;
    double evidence = 0.0;  ///< In favour of the change [nats].
    int oldest = 0;         ///< Age from which the new model holds.
  };

  /// Where a trajectory that bends was `seconds` (<= 0) from now: about where the track's mean was, give or
  /// take what a manoeuvre may have led it off.
  Anchor anchor(const CloudMoments& moments, double seconds) const;

  /// A track after its update, as it is judged.
  struct Suspect {
    int slot = 0;
    const JointTrack& track;
    AgeSpan memory;  ///< The scans that it remembers.
  };

  /// Judges a track after its update; where the model (or the line) changes, `cloud` holds its trajectories.
  Judgement judge(const Suspect& suspect, JointLikelihood& likelihood, JointSampler& sampler,
                  core::Random& random, JointCloud& cloud) const;

 private:
  Judgement leave_line(const Suspect& suspect, JointLikelihood& likelihood, JointSampler& sampler,
                       core::Random& random, JointCloud& cloud) const;
  Judgement leave_curve(const Suspect& suspect, JointLikelihood& likelihood, JointSampler& sampler,
                        core::Random& random, JointCloud& cloud) const;
  double gain_of_other_line(const Suspect& suspect, JointLikelihood& likelihood, JointSampler& sampler,
                            core::Random& random, JointCloud& cloud) const;
  int oldest_of_window(const csht::ScanHistory& scans) const;
  bool doubtful(const RecentEvidence& recent, int scans) const;
  SamplingTask task(const Suspect& suspect, const AgeSpan& ages, bool curved) const;
  SamplingTask anchored_task(const Suspect& suspect, const AgeSpan& ages, bool curved,
                             const csht::ScanHistory& scans) const;

  JointManoeuvreParams params_;
  int trajectories_;
};

}  // namespace lookout::tracking
