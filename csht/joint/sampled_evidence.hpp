#pragma once

#include <vector>

#include "core/random.hpp"
#include "csht/joint/target_hypothesis.hpp"
#include "csht/joint/trajectory_prior.hpp"
#include "csht/likelihood/claim_set.hpp"
#include "csht/likelihood/scan_history.hpp"
#include "csht/likelihood/sensor_likelihood.hpp"

namespace lookout::csht {

/// Whether the point lies in the field of view of a scan.
bool in_view(const ScanTable& scan, const Eigen::Vector2d& p_earth);

/// Adaptive importance sampling of one trajectory.
struct JointEvidenceParams {
  int samples = 160;          ///< Of the last stage, >= 32.
  int screen_samples = 64;    ///< Of each stage before it, which most candidates do not survive, >= 32.
  int stages = 3;             ///< Stages of a candidate that stays hopeful, >= 1; the last one counts.
  Tolerance first{1.2, 0.5};  ///< Of the first stage; the last stage has `last`.
  Tolerance last{1.0, 0.04};
  Tolerance verdict{1.0, 0.01};  ///< Of the verdict, which has the samples for sharper edges.
  double proposal_scale = 1.1;   ///< The proposal's sigma over the estimated one, > 0.
  double wide_scale = 2.2;       ///< That of the wide part of the proposal, > proposal_scale.
  double wide_share = 0.125;     ///< Share of samples in the wide part, in (0, 1).
  double adapt_share = 0.1;      ///< Least share of samples that adapt the proposal, in (0, 1).
  int verdict_samples = 480;     ///< Of the last word on a target, >= 32.
  double effective = 20.0;       ///< Effective samples that a verdict must rest on, > 0 ...
  int attempts = 3;              ///< ... or this many attempts, each with the proposal of the last, >= 1.
  double hopeless = -8.0;        ///< After its first stage a candidate below these log odds is left [nats].
};

/// Evidence, mean and covariance of a candidate under the exact likelihood.
class JointEvidence {
 public:
  /// @throws std::invalid_argument showing the value that is out of range.
  explicit JointEvidence(const JointEvidenceParams& params);

  /// Samples about `hypothesis` (its mean and covariance propose) and writes what is found into it: mean,
  /// covariance, log odds, samples. Interior births sum over all starts within the window.
  /// @param stages 1 to re-estimate a candidate whose proposal is known to fit.
  void evaluate(const ScanHistory& history, int window_scans, const ClaimSet& claims,
                const TrajectoryPrior& prior, int stages, core::Random& random, TargetHypothesis& hypothesis);

  /// The last word on a hypothesis whose mean and covariance fit: samples of their own, so that the choice
  /// of the hypothesis for its evidence does not count in its favour.
  void decide(const ScanHistory& history, int window_scans, const ClaimSet& claims,
              const TrajectoryPrior& prior, core::Random& random, TargetHypothesis& hypothesis);

  int stages() const { return params_.stages; }
  double effective_samples() const { return effective_samples_; }  ///< Of the last stage evaluated.

 private:
  void propose(const TargetHypothesis& hypothesis, int samples, core::Random& random);
  void drop_impossible(const ScanHistory& history, int window_scans, const TrajectoryPrior& prior);
  void weigh(const ScanHistory& history, int window_scans, const ClaimSet& claims,
             const TrajectoryPrior& prior, const Tolerance& tolerance);
  double log_evidence();
  double temper(double heat);
  void flatten(double wanted);
  void moments(TargetHypothesis& hypothesis) const;
  void resample(core::Random& random, TargetHypothesis& hypothesis) const;

  JointEvidenceParams params_;
  std::vector<Eigen::Vector4d> normal_;  ///< A fixed sequence of low discrepancy, standard normal.
  std::vector<double> north_, east_, north_velocity_, east_velocity_;
  std::vector<double> log_proposal_, log_ratio_, weight_;
  std::vector<double> product_, birth_;  ///< Of likelihood ratios; of births beside it.
  std::size_t count_ = 0;                ///< Samples of the stage at hand.
  double effective_samples_ = 0.0;
};

}  // namespace lookout::csht
