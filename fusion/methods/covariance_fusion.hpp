#pragma once

#include <vector>

#include "fusion/fusion_method.hpp"

namespace lookout::fusion {

/// `intersection`: covariance intersection, safe for any correlation between the nodes, with the closed-form
/// weights 1/trace; `least_trace`: with the weights that make the trace of the fused covariance least. `sum`:
/// the plain sum of the inverse covariances, which takes the nodes for independent.
enum class CovarianceWeights { intersection, least_trace, sum };

/// Fusion by the covariances that the nodes send. docs/fusion.md.
class CovarianceFusion final : public FusionMethod {
 public:
  /// `q`: white acceleration [m^2/s^3], >= 0, that ages an estimate. @throws std::invalid_argument.
  CovarianceFusion(CovarianceWeights weights, double q);

  std::span<const FusedState> fuse(std::span<const TrackGroup> groups) override;
  bool needs_covariance() const override { return true; }

 private:
  FusedState fuse_group(const TrackGroup& group);
  void choose_weights();
  void improve_weights();
  Eigen::Matrix4d fused_covariance() const;

  CovarianceWeights weights_;
  double q_;
  std::vector<Eigen::Matrix4d> information_;  ///< Of each contribution of the group at hand.
  std::vector<double> weight_;                ///< Of each, of sum 1 but for `sum`.
  std::vector<FusedState> fused_;
};

/// The covariance of a contribution's `current`. The estimate must carry one.
Eigen::Matrix4d covariance_at(const LocalTrack& track, std::int64_t utime, double q);

}  // namespace lookout::fusion
