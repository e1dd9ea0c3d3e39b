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
  fused_.assign(groups.size(), FusedState{});
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto& contributions = groups[g].contributions;
    weights_.assign(contributions.size(), 1.0);
    if (!groups[g].is_new) support(groups[g], weights_);
    normalise(weights_);
    for (std::size_t i = 0; i < contributions.size(); ++i)
      fused_[g].state += weights_[i] * contributions[i].current;  // [Li2018] Eq. (19)
  }
  return fused_;
}

void SingleNode::support(const TrackGroup& group, std::vector<double>& support) {
  const auto lowest = std::min_element(
      group.contributions.begin(), group.contributions.end(),
      [](const auto& a, const auto& b) { return a.track->newest().node_id < b.track->newest().node_id; });
  std::fill(support.begin(), support.end(), 0.0);
  support[static_cast<std::size_t>(lowest - group.contributions.begin())] = 1.0;
}

}  // namespace lookout::fusion
