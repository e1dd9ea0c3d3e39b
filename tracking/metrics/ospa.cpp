#include "tracking/metrics/ospa.hpp"

#include <algorithm>
#include <cmath>

#include "core/parameter_check.hpp"

namespace lookout::tracking {

Ospa::Ospa(const OspaParams& params) : params_(params) {
  core::require(params.cutoff > 0.0, "OSPA cutoff must be > 0", params.cutoff);
  core::require(params.order >= 1.0, "OSPA order must be >= 1", params.order);
}

OspaResult Ospa::operator()(std::span<const Eigen::Vector2d> truth,
                            std::span<const Eigen::Vector2d> estimate) {
  OspaResult result;
  result.num_truth = static_cast<int>(truth.size());
  result.num_tracks = static_cast<int>(estimate.size());
  const std::size_t larger = std::max(truth.size(), estimate.size());
  const std::size_t smaller = std::min(truth.size(), estimate.size());
  if (larger == 0) return result;

  cost_.resize(static_cast<Eigen::Index>(truth.size()), static_cast<Eigen::Index>(estimate.size()));
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (std::size_t j = 0; j < estimate.size(); ++j) {
      const double distance = std::min(params_.cutoff, (truth[i] - estimate[j]).norm());
      cost_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = std::pow(distance, params_.order);
    }
  double localization = 0.0;
  if (smaller > 0) {
    const std::vector<int>& column_of_row = solver_.solve(cost_);
    for (std::size_t i = 0; i < truth.size(); ++i)
      if (column_of_row[i] >= 0) localization += cost_(static_cast<Eigen::Index>(i), column_of_row[i]);
  }
  const auto n = static_cast<double>(larger);
  const double cardinality = std::pow(params_.cutoff, params_.order) * static_cast<double>(larger - smaller);
  const double root = 1.0 / params_.order;
  result.localization = std::pow(localization / n, root);           // [Yan2018] Eq. (45)
  result.cardinality = std::pow(cardinality / n, root);             // [Yan2018] Eq. (46)
  result.total = std::pow((localization + cardinality) / n, root);  // [Yan2018] Eq. (44)
  return result;
}

}  // namespace lookout::tracking
