#include "tracking/baselines/gaussian/weighted_target.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "core/parameter_check.hpp"
#include "tracking/baselines/gaussian/target_mixture.hpp"

namespace lookout::tracking {
namespace {

/// A component summed over its models, once for all comparisons.
struct Summary {
  Eigen::Vector4d mean;
  Eigen::Matrix4d inverse;  // Of the covariance.
  double position_variance = 0.0;
  std::int64_t label = 0;
};

std::vector<Summary> summaries_of(const std::vector<WeightedTarget>& mixture) {
  std::vector<Summary> result;
  for (const auto& component : mixture) {
    const Eigen::Matrix4d covariance = component.target.covariance();
    result.push_back({component.target.mean(), covariance.inverse(), covariance.topLeftCorner<2, 2>().trace(),
                      component.label});
  }
  return result;
}

/// Whether a component is close to a heavier one, by its own covariance.
bool is_close(const Summary& heavy, const Summary& light, const ReductionParams& params) {
  if (!params.across_labels && heavy.label != light.label) return false;
  const Eigen::Vector4d offset = light.mean - heavy.mean;
  // A part of the state is never farther than the whole.
  if (offset.head<2>().squaredNorm() > params.merge_distance * light.position_variance) return false;
  return offset.dot(light.inverse * offset) < params.merge_distance;
}

/// The heaviest components, each with all that are close to it; `mixture` is in falling order of weight.
std::vector<WeightedTarget> merge_close(const std::vector<WeightedTarget>& mixture,
                                        const ReductionParams& params) {
  const std::vector<Summary> summaries = summaries_of(mixture);
  std::vector<char> used(mixture.size(), 0);
  std::vector<WeightedTarget> merged;
  for (std::size_t first = 0; first < mixture.size(); ++first) {
    if (used[first]) continue;
    TargetMixture sum(mixture[first].target);
    double detected = 0.0;
    for (std::size_t i = first; i < mixture.size(); ++i) {
      if (used[i] || (i != first && !is_close(summaries[first], summaries[i], params))) continue;
      used[i] = 1;
      sum.add(mixture[i].weight, mixture[i].target);
      detected += mixture[i].detected;
    }
    merged.push_back({sum.weight(), sum.merged(), mixture[first].label, detected});
  }
  return merged;
}

void scale_to(double total, std::vector<WeightedTarget>& mixture) {
  const double kept = total_weight(mixture);
  if (kept <= 0.0) return;
  for (auto& component : mixture) component.weight *= total / kept;
}

}  // namespace

void ReductionParams::validate() const {
  core::require_share_below_one("least_share", least_share);
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
  std::vector<WeightedTarget> merged = merge_close(mixture, params);
  std::stable_sort(merged.begin(), merged.end(), heavier);
  if (merged.size() > static_cast<std::size_t>(params.most))
    merged.resize(static_cast<std::size_t>(params.most));
  scale_to(total, merged);
  mixture = std::move(merged);
}

}  // namespace lookout::tracking
