#pragma once

#include <array>

#include "core/random.hpp"
#include "csht/joint/density/target_track.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"
#include "csht/joint/evidence/trajectory_sampler.hpp"
#include "tracking/joint/joint_params.hpp"

namespace lookout::tracking {

/// Decides whether a track's motion is another one: constant velocity, constant turn or constant
/// acceleration. Of a young track the motion over its whole life may be wrong, and each is tried over all its
/// scans. Later each is tried over the latest scans, against the evidence that the present one had there. The
/// tests are those of a multiple-model filter ([Blom1988]) with the likelihood of whole windows.
/// docs/joint_tracker.md.
class MotionChange {
 public:
  /// @param params validated. @param trajectories in a cloud.
  MotionChange(const MotionChangeParams& params, int trajectories);

  /// keep: as it is. change: the motion is another one since some scan. rewrite: since the track's first.
  enum class Verdict { keep, change, rewrite };
  /// What was decided of a track's motion.
  struct Judgement {
    Verdict verdict = Verdict::keep;  ///< Whether it changes.
    double evidence = 0.0;            ///< In favour of the change [nats].
    int oldest = 0;                   ///< Age of the scan from which a changed motion holds.
    double life_evidence = 0.0;       ///< Of a rewrite: for the whole life, without `log_share` [nats].
  };

  /// ln of the number of targets that have this motion from their first scan on, over those at constant
  /// velocity.
  double log_share(csht::Motion motion) const;

  /// A prior for where a new trajectory was `seconds` (<= 0) from now: about where the track was, as wide as
  /// a manoeuvre may have led off.
  csht::Anchor anchor(const csht::CloudMoments& moments, double seconds) const;

  /// A track after its update, as it is judged.
  struct Suspect {
    int slot = 0;                    ///< Of the track.
    const csht::TargetTrack& track;  ///< With the newest scan taken in.
    csht::AgeSpan memory;            ///< The scans that its likelihood counts.
  };

  /// Judges a track after its update. Where the verdict is not keep, `cloud` holds the new trajectories.
  Judgement judge(const Suspect& suspect, csht::ScanLikelihood& likelihood, csht::TrajectorySampler& sampler,
                  core::Random& random, csht::TrajectoryCloud& cloud);

 private:
  // What a motion is tried with.
  struct Bench {
    csht::ScanLikelihood& likelihood;
    csht::TrajectorySampler& sampler;
    core::Random& random;
    csht::TrajectoryCloud& cloud;  // Of the best motion.
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
  csht::TrajectoryCloud other_;  ///< Of the motion that is tried now.
};

}  // namespace lookout::tracking
