#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/evidence/proposal_pool.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"

namespace lookout::csht {

/// Where a trajectory was at an earlier time: a Gaussian prior of position and velocity there. Without one,
/// trajectories that left the field of view before the oldest scan cost nothing and are infinitely many.
struct Anchor {
  double seconds = 0.0;  ///< That time, from the newest scan, <= 0.
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
};

/// What to sample: trajectories around a first guess, under the scans of these ages.
struct SamplingTask {
  CloudMoments guess;  ///< Its motion is that of all trajectories.
  AgeSpan ages;
  int self = ScanLikelihood::kNobody;  ///< The track whose own claims do not count.
  int samples = 256;                   ///< A round.
  int rounds = 3;                      ///< Most rounds; later ones propose from the cloud before.
  std::optional<Anchor> anchor;        ///< Absent: anywhere, with the prior density 1.
  double give_up_below = -1e300;       ///< After the first round, stop where the log evidence is below.
};

struct SamplingResult {
  double log_evidence = 0.0;     ///< ln of the integral of the likelihood ratio, per unit prior density.
  double effective_share = 0.0;  ///< Effective size of the cloud over its size.
};

/// Adaptive importance sampling of trajectories under the exact likelihood: gives the density of a target and
/// the evidence for it. [Cappe2004] Sec. 2.
class TrajectorySampler {
 public:
  TrajectorySampler(const TrajectoryCloudParams& params, const TargetPrior& prior, core::Random& random);

  /// Fills `cloud` with the last round's weighted trajectories.
  SamplingResult sample(const SamplingTask& task, ScanLikelihood& likelihood, core::Random& random,
                        TrajectoryCloud& cloud);

  /// Resamples `cloud` by its weights and moves each trajectory, `params.moves` times, by a step of a random
  /// walk with the cloud's covariance, accepted by Metropolis' rule: a density whose edges no proposal fits
  /// stays alive. [Gilks2001] Sec. 3.
  void move(const SamplingTask& task, ScanLikelihood& likelihood, core::Random& random,
            TrajectoryCloud& cloud);

  /// ln of the prior of a trajectory's velocity and of its acceleration or turn rate; 0 of a line that
  /// stands.
  /// @param anchored what it was before is known: of its speed, only that no target is faster than the limit.
  double log_prior(Motion motion, const Trajectory& trajectory, bool anchored) const;

 private:
  void draw(const CloudMoments& around, std::size_t start, TrajectoryCloud& cloud);
  void add_prior(const TrajectoryCloud& cloud, bool anchored, std::span<double> log_weight) const;
  void score(const TrajectoryCloud& cloud, const Trajectory& mean, const SamplingTask& task,
             ScanLikelihood& likelihood, std::span<double> log_target) const;
  void step(const TrajectoryCovariance& root, std::size_t start, const TrajectoryCloud& cloud);
  CloudMoments next_guess(TrajectoryCloud& cloud);

  TrajectoryCloudParams params_;
  TargetPrior prior_;
  ProposalPool pool_;
  std::vector<double> log_weight_, log_ratio_;
  TrajectoryCloud stepped_;  ///< Where the trajectories of a cloud would be after a step.
};

}  // namespace lookout::csht
