#include "tracking/baselines/gaussian/weighted_target.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "core/parameter_check.hpp"
#include "tracking/baselines/gaussian/target_mixture.hpp"

namespace lookout::tracking {
namespace {

/// Squared distance of a component from a heavier one, in the covariance of the lighter one.
bool is_close(const WeightedTarget& heavy, const WeightedTarget& light, double distance) {
  if (heavy.label != light.label) return false;
  const Eigen::Matrix4d covariance = light.target.covariance();
  const Eigen::Vector4d offset = light.target.mean() - heavy.target.mean();
  // A part of the state is never farther than the whole.
  if (offset.head<2>().squaredNorm() > distance * covariance.topLeftCorner<2, 2>().trace()) return false;
  return offset.dot(covariance.inverse() * offset) < distance;
}

/// The heaviest component left, with all that are close to it; `mixture` is in falling order of weight.
WeightedTarget merge_from(std::size_t first, const std::vector<WeightedTarget>& mixture, double distance,
                          std::vector<char>& used) {
  TargetMixture sum(mixture[first].target);
  for (std::size_t i = first; i < mixture.size(); ++i) {
    if (used[i] || (i != first && !is_close(mixture[first], mixture[i], distance))) continue;
    used[i] = 1;
    sum.add(mixture[i].weight, mixture[i].target);
  }
  return {sum.weight(), sum.merged(), mixture[first].label};
}

void scale_to(double total, std::vector<WeightedTarget>& mixture) {
  const double kept = total_weight(mixture);
  if (kept <= 0.0) return;
  for (auto& component : mixture) component.weight *= total / kept;
}

}  // namespace

void ReductionParams::validate() const {
  core::require(least_share >= 0.0 && least_share < 1.0, "least_share must be in [0, 1)", least_share);
  core::require_not_negative("merge_distance", merge_distance);
  core::require(most >= 1, "most must be >= 1", most);
}

double total_weight(const std::vector<WeightedTarget>& mixture) {
  double sum = 0.0;
  for (const auto& component : mixture) sum += component.weight;
  return sum;
}

void reduce(std::vector<WeightedTarget>& mixture, const ReductionParams& params) {
  if (mixture.empty()) return;
  const auto heavier = [](const WeightedTarget& a, const WeightedTarget& b) { return a.weight > b.weight; };
  std::stable_sort(mixture.begin(), mixture.end(), heavier);
  const double total = total_weight(mixture);
  const double least = params.least_share * mixture.front().weight;
  while (mixture.back().weight < least) mixture.pop_back();
  std::vector<char> used(mixture.size(), 0);
  std::vector<WeightedTarget> merged;
  for (std::size_t i = 0; i < mixture.size(); ++i)
    if (!used[i]) merged.push_back(merge_from(i, mixture, params.merge_distance, used));
  std::stable_sort(merged.begin(), merged.end(), heavier);
  if (merged.size() > static_cast<std::size_t>(params.most))
    merged.resize(static_cast<std::size_t>(params.most));
  scale_to(total, merged);
  mixture = std::move(merged);
}

}  // namespace lookout::tracking
