#pragma once

#include <span>
#include <vector>

#include "csht/joint/seeds.hpp"
#include "csht/joint/target_hypothesis.hpp"
#include "csht/joint/trajectory_prior.hpp"
#include "csht/likelihood/claim_set.hpp"

namespace lookout::csht {

/// Fuzzy clustering of the echoes of a window about straight trajectories, with a noise class.
struct JointClusterParams {
  int rounds = 4;               ///< Rounds of membership and least squares, >= 1.
  Tolerance first{1.5, 0.5};    ///< Of the first round: seeds are rough.
  Tolerance last{1.0, 0.25};    ///< Of the last round.
  double merge_distance = 3.0;  ///< Clusters nearer than this (squared Mahalanobis, 4 degrees) are one, > 0.
  double min_support = 1.5;     ///< Clusters with fewer echoes of their own (expected) are deleted, > 0.
  double delete_below = -12.0;  ///< Clusters with lower log odds of existence are deleted [nats].
};

/// Log odds of existence of a peak by Laplace's approximation: its height (log-likelihood ratio) times the
/// volume below it times the prior density, e^`log_density` targets per m^2 and (m/s)^2 [nats].
double laplace_log_odds(double log_ratio, const Eigen::Matrix4d& covariance, double log_density);

/// Turns seeds into trajectories with covariance: memberships of the echoes (to a cluster, to its rivals, to
/// the noise class), weighted least squares, combination of clusters that agree, deletion of weak ones.
/// Keeps its buffers.
class JointClusters {
 public:
  /// @throws std::invalid_argument showing the value that is out of range.
  explicit JointClusters(const JointClusterParams& params);

  /// Refines `hypotheses` in place (their means are the start) and scores them; one that scored higher before
  /// stays as it was.
  void refine(const ScanHistory& history, int window_scans, const ClaimSet& claims,
              const TrajectoryPrior& prior, std::vector<TargetHypothesis>& hypotheses);

  /// Log-likelihood ratio of each mean, and the log odds of existence that follow by Laplace's approximation.
  void score(const ScanHistory& history, int window_scans, const ClaimSet& claims,
             const TrajectoryPrior& prior, std::span<TargetHypothesis> hypotheses);

  /// Leaves the distinct ones that are not hopeless, best log odds first.
  void combine_and_delete(std::vector<TargetHypothesis>& hypotheses) const;

 private:
  struct Echo {
    std::size_t hypothesis = 0;
    int age = 0;
    std::size_t index = 0;            // Of the slot or the detection.
    double weight = 0.0;              // Likelihood of being this hypothesis's, before its rivals are asked.
    double none = 0.0;                // Likelihood that it has no echo here.
    double range_residual = 0.0;      // [m].
    double bearing_residual = 0.0;    // [rad].
    double range = 0.0;               // Of the prediction [m].
    double bearing = 0.0;             // Of the prediction, from the scan's axis [rad].
    Eigen::Vector2d direction{1, 0};  // To the prediction, a unit vector.
  };
  struct Step;

  void find_echoes(const ScanHistory& history, int window, const ClaimSet& claims, const Tolerance& tolerance,
                   std::span<const TargetHypothesis> hypotheses);
  static void predict(const ScanTable& scan, const Eigen::Vector4d& state, double seconds, Echo& echo);
  void beam_echoes(const ScanTable& scan, const BeamMask* mask, const Tolerance& tolerance, Echo echo);
  void point_echoes(const ScanTable& scan, const BeamMask* mask, const Tolerance& tolerance, Echo echo);
  void let_rivals_share(const ScanHistory& history, int window, std::span<const TargetHypothesis> hypotheses);
  void least_squares(const ScanHistory& history, double max_speed, const Tolerance& tolerance,
                     std::span<TargetHypothesis> hypotheses);
  JointClusterParams params_;
  std::vector<Echo> echoes_;
  std::vector<std::vector<double>> claims_by_echo_;  ///< Per age and slot: sum of existence x likelihood.
  std::vector<double> north_, east_, north_velocity_, east_velocity_, sum_;
  std::vector<double> existence_;
  std::vector<TargetHypothesis> before_;
};

}  // namespace lookout::csht
