#include "tracking/baselines/gaussian/target_mixture.hpp"

namespace lookout::tracking {

void ModeSum::add(double weight, const GaussianMode& mode) {
  const Eigen::Vector4d offset = mode.mean - centre_;
  weight_ += weight;
  first_ += weight * offset;
  second_ += weight * (mode.covariance + offset * offset.transpose());
}

GaussianMode ModeSum::merged() const {
  GaussianMode mode{weight_, centre_, Eigen::Matrix4d::Zero()};
  if (weight_ <= 0.0) return mode;
  const Eigen::Vector4d offset = first_ / weight_;
  mode.mean = centre_ + offset;
  mode.covariance = second_ / weight_ - offset * offset.transpose();
  return mode;
}

TargetMixture::TargetMixture(const GaussianTarget& first)
    : first_(first), sums_{ModeSum(first.modes[0].mean), ModeSum(first.modes[0].mean)} {}

void TargetMixture::add(double weight, const GaussianTarget& target) {
  weight_ += weight;
  for (std::size_t m = 0; m < target.used().size(); ++m)
    sums_[m].add(weight * target.modes[m].weight, target.modes[m]);
}

GaussianTarget TargetMixture::merged() const {
  GaussianTarget result = first_;
  for (std::size_t m = 0; m < result.used().size(); ++m) {
    if (sums_[m].weight() <= 0.0) {
      result.modes[m].weight = 0.0;
      continue;
    }
    result.modes[m] = sums_[m].merged();
    result.modes[m].weight /= weight_;
  }
  return result;
}

}  // namespace lookout::tracking
