#pragma once

#include <cstdint>
#include <vector>

#include "tracking/baselines/gaussian/gaussian_target.hpp"

namespace lookout::tracking {

/// One component of a Gaussian mixture over targets.
struct WeightedTarget {
  double weight = 0.0;     ///< Expected number of targets that it stands for, >= 0.
  GaussianTarget target;   ///< Where they are.
  std::int64_t label = 0;  ///< Whose target it is, where its mixture tells that.
  double detected = 0.0;  ///< Part of the weight that the newest scan detected, where its mixture tells that.
};

/// How a mixture is kept small.
struct ReductionParams {
  /// Components of less than this share of the heaviest are dropped, in [0, 1).
  double least_share = 1e-3;
  /// Squared Mahalanobis distance of a state from a heavier one below which both are merged, >= 0.
  double merge_distance = 0.5;
  int most = 8;                ///< Components that are kept, >= 1.
  bool across_labels = false;  ///< Merge components of different labels too; the heavier one's stays.

  /// @throws std::invalid_argument naming the first value out of range.
  void validate() const;
};

/// Drops light components, merges close ones and keeps the heaviest; the total weight stays.
/// [Vo2006] Table II.
void reduce(std::vector<WeightedTarget>& mixture, const ReductionParams& params);

/// Sum of the weights.
double total_weight(const std::vector<WeightedTarget>& mixture);

}  // namespace lookout::tracking
