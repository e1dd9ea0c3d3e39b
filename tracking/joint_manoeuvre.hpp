#pragma once

#include <array>

#include "core/random.hpp"
#include "tracking/joint_likelihood.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/joint_sampler.hpp"
#include "tracking/joint_track.hpp"

namespace lookout::tracking {

/// Three motions a track: a straight line and a turn at a constant rate, which are remembered for as long as
/// they fit, and a constant acceleration, which is forgotten sooner. A young track may be on the wrong line,
/// or its target may have moved in another way from the first on: that is tried over its whole life. Later
/// each motion is held against the others on the latest scans.
class JointManoeuvre {
 public:
  JointManoeuvre(const JointManoeuvreParams& params, int trajectories);

  /// `change`: the motion is another one since some scan. `rewrite`: the whole life was another one.
  enum class Verdict { keep, change, rewrite };
  struct Judgement {
    Verdict verdict = Verdict::keep;
    double evidence = 0.0;       ///< In favour of the change [nats].
    int oldest = 0;              ///< Age from which a changed motion holds.
    double life_evidence = 0.0;  ///< For a whole life rewritten, its motion's share not counted [nats].
  };

  /// ln of the share of targets that move so from their first scan on, of a line's.
  double log_share(Motion motion) const;

  /// Where a trajectory was `seconds` (<= 0) from now: about where the track's mean was, give or
  /// take what a manoeuvre may have led it off.
  Anchor anchor(const CloudMoments& moments, double seconds) const;

  /// A track after its update, as it is judged.
  struct Suspect {
    int slot = 0;
    const JointTrack& track;
    AgeSpan memory;  ///< The scans that it remembers.
  };

  /// Judges a track after its update; where the motion (or the line) changes, `cloud` holds its trajectories.
  Judgement judge(const Suspect& suspect, JointLikelihood& likelihood, JointSampler& sampler,
                  core::Random& random, JointCloud& cloud);

 private:
  /// What a motion is tried with.
  struct Bench {
    JointLikelihood& likelihood;
    JointSampler& sampler;
    core::Random& random;
    JointCloud& cloud;  ///< Of the verdict.
  };
  Judgement doubt_life(const Suspect& suspect, const Bench& bench);
  Judgement doubt(const Suspect& suspect, const Bench& bench);
  Judgement compare(const Suspect& suspect, int oldest, const Bench& bench);
  double try_motion(Motion motion, double best, const Suspect& suspect, const AgeSpan& ages,
                    const Bench& bench);
  std::array<Motion, 2> motions_to_try(const Suspect& suspect, const csht::ScanHistory& scans) const;
  int oldest_of_window(const csht::ScanHistory& scans) const;
  bool doubtful(const RecentEvidence& recent, int scans) const;
  SamplingTask task(const Suspect& suspect, const AgeSpan& ages, Motion motion) const;
  SamplingTask anchored_task(const Suspect& suspect, const AgeSpan& ages, Motion motion,
                             const csht::ScanHistory& scans) const;
  CloudMoments loosened(const CloudMoments& moments, Motion motion) const;

  JointManoeuvreParams params_;
  int samples_;
  JointCloud other_;  ///< Of a motion that is tried.
};

}  // namespace lookout::tracking
