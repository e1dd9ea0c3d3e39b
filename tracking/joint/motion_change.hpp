#pragma once

#include <array>

#include "core/random.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"
#include "csht/joint/evidence/trajectory_sampler.hpp"
#include "tracking/joint/joint_params.hpp"

namespace lookout::tracking {

/// Three motions a track: a straight line and a turn at a constant rate, which are remembered for as long as
/// they fit, and a constant acceleration, which is forgotten sooner. A young track may be on the wrong line,
/// or its target may have moved in another way from the first on: that is tried over its whole life. Later
/// each motion is held against the others on the latest scans.
class MotionChange {
 public:
  MotionChange(const MotionChangeParams& params, int trajectories);

  /// `change`: the motion is another one since some scan. `rewrite`: the whole life was another one.
  enum class Verdict { keep, change, rewrite };
  struct Judgement {
    Verdict verdict = Verdict::keep;
    double evidence = 0.0;       ///< In favour of the change [nats].
    int oldest = 0;              ///< Age from which a changed motion holds.
    double life_evidence = 0.0;  ///< For a whole life rewritten, its motion's share not counted [nats].
  };

  /// ln of the share of targets that move so from their first scan on, of a line's.
  double log_share(csht::Motion motion) const;

  /// Where a trajectory was `seconds` (<= 0) from now: about where the track's mean was, give or
  /// take what a manoeuvre may have led it off.
  csht::Anchor anchor(const csht::CloudMoments& moments, double seconds) const;

  /// A track after its update, as it is judged.
  struct Suspect {
    int slot = 0;
    const csht::TargetTrack& track;
    csht::AgeSpan memory;  ///< The scans that it remembers.
  };

  /// Judges a track after its update; where the motion (or the line) changes, `cloud` holds its trajectories.
  Judgement judge(const Suspect& suspect, csht::ScanLikelihood& likelihood, csht::TrajectorySampler& sampler,
                  core::Random& random, csht::TrajectoryCloud& cloud);

 private:
  /// What a motion is tried with.
  struct Bench {
    csht::ScanLikelihood& likelihood;
    csht::TrajectorySampler& sampler;
    core::Random& random;
    csht::TrajectoryCloud& cloud;  ///< Of the verdict.
  };
  Judgement doubt_life(const Suspect& suspect, const Bench& bench);
  Judgement doubt(const Suspect& suspect, const Bench& bench);
  Judgement compare(const Suspect& suspect, int oldest, const Bench& bench);
  double try_motion(csht::Motion motion, double best, const Suspect& suspect, const csht::AgeSpan& ages,
                    const Bench& bench);
  std::array<csht::Motion, 2> motions_to_try(const Suspect& suspect, const csht::ScanHistory& scans) const;
  int oldest_of_window(const csht::ScanHistory& scans) const;
  bool doubtful(const csht::RecentEvidence& recent, int scans) const;
  csht::SamplingTask task(const Suspect& suspect, const csht::AgeSpan& ages, csht::Motion motion) const;
  csht::SamplingTask anchored_task(const Suspect& suspect, const csht::AgeSpan& ages, csht::Motion motion,
                                   const csht::ScanHistory& scans) const;
  csht::CloudMoments loosened(const csht::CloudMoments& moments, csht::Motion motion) const;

  MotionChangeParams params_;
  int samples_;
  csht::TrajectoryCloud other_;  ///< Of a motion that is tried.
};

}  // namespace lookout::tracking
