#include "tracking/metrics/ospa.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

Ospa::Ospa(const OspaParams& params) : params_(params) {
  core::require_positive("OSPA cutoff", params.cutoff);
  core::require(params.order >= 1.0, "OSPA order must be >= 1 or inf", params.order);
}

void Ospa::fill_distances(std::span<const Eigen::Vector2d> truth, std::span<const Eigen::Vector2d> estimate) {
  distance_.resize(static_cast<Eigen::Index>(truth.size()), static_cast<Eigen::Index>(estimate.size()));
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (std::size_t j = 0; j < estimate.size(); ++j)
      distance_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          std::min(params_.cutoff, (truth[i] - estimate[j]).norm());
}

OspaResult Ospa::operator()(std::span<const Eigen::Vector2d> truth,
                            std::span<const Eigen::Vector2d> estimate) {
  fill_distances(truth, estimate);
  return of_distances(distance_);
}

OspaResult Ospa::of_distances(const Eigen::MatrixXd& distance) {
  OspaResult result;
  result.num_truth = static_cast<int>(distance.rows());
  result.num_tracks = static_cast<int>(distance.cols());
  const Eigen::Index larger = std::max(distance.rows(), distance.cols());
  const Eigen::Index smaller = std::min(distance.rows(), distance.cols());
  if (larger == 0) return result;
  const auto n = static_cast<double>(larger);
  const auto surplus = static_cast<double>(larger - smaller);
  const double root = 1.0 / params_.order;  // 0 for an infinite order, where a power of it is 1
  if (smaller > 0) {
    assignment_.solve(distance, params_.order);
    result.localization =
        power_norm(assignment_.paired(), params_.order) / std::pow(n, root);  // [Yan2018] Eq. (45)
  }
  if (surplus > 0.0) result.cardinality = params_.cutoff * std::pow(surplus / n, root);  // [Yan2018] Eq. (46)
  result.total =
      power_norm(std::array{result.localization, result.cardinality}, params_.order);  // [Yan2018] Eq. (44)
  return result;
}

}  // namespace lookout::tracking
