#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "csht/joint/density/engine_params.hpp"
#include "csht/joint/evidence/proposal_pool.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"

namespace lookout::csht {

/// Where a trajectory was at an earlier time: a normal prior of position [m] and velocity [m/s] there.
/// Without one, trajectories that were out of view before would be infinitely many, since no scan speaks
/// against them.
struct Anchor {
  double seconds = 0.0;                                      ///< That time, from the newest scan, <= 0.
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();            ///< Position, then velocity, earth frame.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();  ///< Of the same.
};

/// What to sample: trajectories around a first guess, under the scans of these ages.
struct SamplingTask {
  CloudMoments guess;                  ///< Its motion is that of all trajectories.
  AgeSpan ages;                        ///< The scans that count.
  int self = ScanLikelihood::kNobody;  ///< Slot of the track, whose own claims do not count.
  int samples = 256;                   ///< Trajectories drawn in a round.
  int rounds = 3;                      ///< Most rounds; each proposes from the cloud of the one before.
  std::optional<Anchor> anchor;        ///< Absent: no prior of the position.
  double give_up_below = -1e300;       ///< No further round where the log evidence is below [nats].
};

/// What a sampling gives beside the cloud.
struct SamplingResult {
  double log_evidence = 0.0;     ///< ln of the integral of prior times likelihood ratio [nats], where the
                                 ///< prior density of standing targets is taken for 1 / (m^2 (m/s)^2).
  double effective_share = 0.0;  ///< Effective size of the cloud over its size, in (0, 1].
};

/// Adaptive importance sampling of trajectories under the exact likelihood: gives the density of a target and
/// the evidence for it. [Cappe2004] Sec. 2.
class TrajectorySampler {
 public:
  /// @param params validated. @param random draws the pool of proposals.
  TrajectorySampler(const TrajectoryCloudParams& params, const TargetPrior& prior, core::Random& random);

  /// Fills `cloud` with the weighted trajectories of the last round. [Cappe2004] Sec. 2: each has the weight
  /// prior x likelihood ratio / proposal density, whose mean estimates the evidence.
  SamplingResult sample(const SamplingTask& task, ScanLikelihood& likelihood, core::Random& random,
                        TrajectoryCloud& cloud);

  /// Resamples `cloud` by its weights and moves each trajectory, `params.moves` times, by a step of a random
  /// walk with the cloud's covariance, accepted by Metropolis' rule: that works even where the density has
  /// edges which no proposal fits. [Gilks2001] Sec. 3. `cloud` keeps its size, at equal weights.
  void move(const SamplingTask& task, ScanLikelihood& likelihood, core::Random& random,
            TrajectoryCloud& cloud);

  /// ln of the prior density of a trajectory's velocity, over that of standing still, and of its acceleration
  /// or turn rate.
  /// @param anchored its earlier velocity is known, so that only the speed limit is applied to this one.
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
