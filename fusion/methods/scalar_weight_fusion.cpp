#include "fusion/methods/scalar_weight_fusion.hpp"

#include <algorithm>
#include <numeric>

namespace lookout::fusion {

void normalise(std::vector<double>& support) {
  constexpr double kNought = 1e-12;  // docs/fusion.md, flaw 1: the printed form is 0/0 here.
  const double sum = std::accumulate(support.begin(), support.end(), 0.0);
  const double equal = 1.0 / static_cast<double>(support.size());
  for (double& weight : support) weight = sum < kNought ? equal : weight / sum;
}

std::span<const FusedState> ScalarWeightFusion::fuse(std::span<const TrackGroup> groups) {
  look_at_all(groups);
  errors_.learn(groups);
  fused_.clear();
  for (const TrackGroup& group : groups) {
    weights_.assign(group.contributions.size(), 1.0);
    if (!group.is_new) support(group, weights_);
    normalise(weights_);
    fused_.push_back(weighted_mean(group));
  }
  return fused_;
}

FusedState ScalarWeightFusion::weighted_mean(const TrackGroup& group) const {
  FusedState fused;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const Contribution& contribution = group.contributions[i];
    fused.state += weights_[i] * contribution.current;  // [Li2018] Eq. (19)
    fused.covariance += weights_[i] * weights_[i] * errors_.covariance_of(group, contribution);
  }
  return fused;
}

void SingleNode::support(const TrackGroup& group, std::vector<double>& support) {
  const auto lowest = std::min_element(
      group.contributions.begin(), group.contributions.end(),
      [](const auto& a, const auto& b) { return a.track->newest().node_id < b.track->newest().node_id; });
  std::fill(support.begin(), support.end(), 0.0);
  support[static_cast<std::size_t>(lowest - group.contributions.begin())] = 1.0;
}

}  // namespace lookout::fusion
