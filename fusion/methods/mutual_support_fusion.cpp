#include "fusion/methods/mutual_support_fusion.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::fusion {
namespace {

/// The principal eigenvector of a matrix without negative entries, by power iteration.
Eigen::VectorXd principal_eigenvector(const Eigen::MatrixXd& matrix) {
  constexpr int kIterations = 50;
  Eigen::VectorXd vector = Eigen::VectorXd::Ones(matrix.rows());
  for (int k = 0; k < kIterations; ++k) vector = (matrix * vector).normalized();
  return vector;
}

}  // namespace

void MutualSupportFusion::compare_all_pairs(const TrackGroup& group) {
  const auto n = static_cast<Eigen::Index>(group.contributions.size());
  mutual_.resize(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto& a = group.contributions[static_cast<std::size_t>(i)].current;
      const auto& b = group.contributions[static_cast<std::size_t>(j)].current;
      mutual_(i, j) = (a.head<2>() - b.head<2>()).norm();
    }
  }
}

void MutualSupportFusion::support_from_prediction(const TrackGroup& group,
                                                  std::vector<double>& support) const {
  for (std::size_t i = 0; i < support.size(); ++i)
    support[i] = (group.contributions[i].current.head<2>() - group.predicted.head<2>()).norm();
  const double largest = *std::max_element(support.begin(), support.end());
  for (double& entry : support) entry = largest > 0.0 ? 1.0 - entry / largest : 1.0;
}

void MutualSupportFusion::support(const TrackGroup& group, std::vector<double>& support) {
  if (variant_ == MutualSupport::c) return support_from_prediction(group, support);
  compare_all_pairs(group);
  const double largest = mutual_.maxCoeff();
  if (largest == 0.0) return;
  const double entries = static_cast<double>(mutual_.size());  // The zero distances to oneself count too.
  if (variant_ == MutualSupport::d) {
    mutual_ = (-mutual_.array() / (mutual_.sum() / entries)).exp();
  } else {
    mutual_ = 1.0 - mutual_.array() / largest;
  }
  const Eigen::VectorXd sums =
      variant_ == MutualSupport::a ? principal_eigenvector(mutual_) : mutual_.rowwise().sum().eval();
  std::copy(sums.begin(), sums.end(), support.begin());
}

}  // namespace lookout::fusion
