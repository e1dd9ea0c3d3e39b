#pragma once

#include <vector>

#include "fusion/fusion_method.hpp"
#include "fusion/learned_geometry.hpp"

namespace lookout::fusion {

/// Methods that give each contribution one number: the fused state is the weighted mean of all four
/// components, without memory of the global track. [Li2018] Eq. (19).
///
/// Its covariance, of which the paper says nothing, is the sum of w_i^2 P_i, where P_i follows from how the
/// nodes disagree (LearnedGeometry, which has no say in the weights). It takes the nodes' errors for
/// independent.
class ScalarWeightFusion : public FusionMethod {
 public:
  /// The weighted mean of each group; valid until the next call.
  std::span<const FusedState> fuse(std::span<const TrackGroup> groups) final;
  void reset() final { errors_.reset(); }  ///< Forgets the nodes' errors.

 protected:
  /// @param errors where learning of the nodes' errors begins.
  explicit ScalarWeightFusion(const LearnedGeometryParams& errors) : errors_(errors) {}
  /// Called once a time, before the groups one by one.
  virtual void look_at_all(std::span<const TrackGroup> /*groups*/) {}
  /// Writes the support of each contribution, >= 0, of any sum; `support` has their number and holds ones.
  virtual void support(const TrackGroup& group, std::vector<double>& support) = 0;

 private:
  FusedState weighted_mean(const TrackGroup& group) const;

  LearnedGeometry errors_;
  std::vector<double> weights_;
  std::vector<FusedState> fused_;
};

/// Scales `support` to sum 1; equal weights where the sum is nought. [Li2018] Eq. (18).
void normalise(std::vector<double>& support);

/// Equal weights.
class MeanFusion final : public ScalarWeightFusion {
 public:
  /// @param errors where learning of the nodes' errors begins.
  explicit MeanFusion(const LearnedGeometryParams& errors = {}) : ScalarWeightFusion(errors) {}

 private:
  void support(const TrackGroup& /*group*/, std::vector<double>& /*support*/) override {}
};

/// No fusion: the estimate of the node with the lowest id that sees the target.
class SingleNode final : public ScalarWeightFusion {
 public:
  /// @param errors where learning of the nodes' errors begins.
  explicit SingleNode(const LearnedGeometryParams& errors = {}) : ScalarWeightFusion(errors) {}

 private:
  void support(const TrackGroup& group, std::vector<double>& support) override;
};

}  // namespace lookout::fusion
