#pragma once

#include <Eigen/Core>

#include "fusion/methods/scalar_weight_fusion.hpp"

namespace lookout::fusion {

/// The four reconstructions of DW-DMSTF (distributed multi-sensor track fusion with dynamic weights), whose
/// original text is not at hand; docs/fusion.md. Current positions only.
/// `a`: principal eigenvector of the mutual supports 1 - d/max d; `b`: their row sums; `c`: support against
/// the predicted global position; `d`: row sums of exp(-d/mean d).
enum class MutualSupport { a, b, c, d };

/// Weights by how well the nodes' estimates agree with one another.
class MutualSupportFusion final : public ScalarWeightFusion {
 public:
  /// One of the paper's four variants, dw_a to dw_d.
  explicit MutualSupportFusion(MutualSupport variant, const LearnedGeometryParams& errors = {})
      : ScalarWeightFusion(errors), variant_(variant) {}

 private:
  void support(const TrackGroup& group, std::vector<double>& support) override;
  void support_from_prediction(const TrackGroup& group, std::vector<double>& support) const;
  void compare_all_pairs(const TrackGroup& group);

  MutualSupport variant_;
  Eigen::MatrixXd mutual_;  ///< Distances, then supports, of all pairs.
};

}  // namespace lookout::fusion
