#pragma once

#include <vector>

#include "core/random.hpp"
#include "tracking/joint_likelihood.hpp"
#include "tracking/joint_params.hpp"
#include "tracking/proposal_pool.hpp"

namespace lookout::tracking {

/// What to sample: trajectories around a first guess, under the scans of these ages.
struct SamplingTask {
  CloudMoments guess;
  AgeSpan ages;
  int self = JointLikelihood::kNobody;  ///< The track whose own claims do not count.
  int samples = 256;                    ///< A round.
  int rounds = 3;                       ///< Most rounds; later ones propose from the cloud before.
  bool curved = false;                  ///< Accelerations too.
  double give_up_below = -1e300;        ///< After the first round, stop where the log evidence is below.
};

struct SamplingResult {
  double log_evidence = 0.0;     ///< ln of the integral of the likelihood ratio, per unit prior density.
  double effective_share = 0.0;  ///< Effective size of the cloud over its size.
};

/// Adaptive importance sampling of trajectories under the exact likelihood: gives the density of a target and
/// the evidence for it. [Cappe2004] Sec. 2; the prior is flat up to the speed limit.
class JointSampler {
 public:
  JointSampler(const JointCloudParams& params, double max_speed, core::Random& random);

  /// Fills `cloud` with the last round's weighted trajectories.
  SamplingResult sample(const SamplingTask& task, JointLikelihood& likelihood, core::Random& random,
                        JointCloud& cloud);

  /// ln of the prior of a velocity [m/s] and an acceleration [m/s^2], 0 for a slow target on a straight line.
  double log_prior(double speed, double acceleration, bool curved) const;

 private:
  void draw(const CloudMoments& around, std::size_t start, JointCloud& cloud);
  void add_prior(const JointCloud& cloud);
  CloudMoments next_guess(JointCloud& cloud);

  JointCloudParams params_;
  double max_speed_;
  ProposalPool pool_;
  std::vector<double> log_weight_;
};

}  // namespace lookout::tracking
