#include "tools/experiments/tracking/nees.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>

namespace lookout::tools {

double mean_nees(const core::GroundTruth& truth, std::span<const core::MotionElement> elements) {
  if (truth.targets.empty() || elements.empty())
    throw std::invalid_argument("NEES needs targets and elements, got " +
                                std::to_string(truth.targets.size()) + " and " +
                                std::to_string(elements.size()));
  double sum = 0.0;
  for (const auto& element : elements) {
    const auto nearest =
        std::min_element(truth.targets.begin(), truth.targets.end(), [&](const auto& a, const auto& b) {
          return (a.position - element.position).norm() < (b.position - element.position).norm();
        });
    Eigen::Vector4d error;
    error << element.position - nearest->position, element.velocity - nearest->velocity;
    sum += error.dot(element.covariance.llt().solve(error)) / 4.0;
  }
  return sum / static_cast<double>(elements.size());
}

}  // namespace lookout::tools
