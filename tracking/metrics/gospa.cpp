#include "tracking/metrics/gospa.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {

Gospa::Gospa(const OspaParams& params) : params_(Ospa(params).params()) {}

GospaResult Gospa::operator()(std::span<const Eigen::Vector2d> truth,
                              std::span<const Eigen::Vector2d> estimate) {
  const double limit = std::pow(params_.cutoff, params_.order);
  cost_.resize(static_cast<Eigen::Index>(truth.size()), static_cast<Eigen::Index>(estimate.size()));
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (std::size_t j = 0; j < estimate.size(); ++j)
      cost_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          std::min(limit, std::pow((truth[i] - estimate[j]).norm(), params_.order));

  int pairs = 0;
  double localization = 0.0;
  if (!truth.empty() && !estimate.empty()) {
    const std::vector<int>& column_of_row = solver_.solve(cost_);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (column_of_row[i] < 0) continue;
      const double cost = cost_(static_cast<Eigen::Index>(i), column_of_row[i]);
      if (cost >= limit) continue;
      ++pairs;
      localization += cost;
    }
  }
  GospaResult result;
  result.num_missed = static_cast<int>(truth.size()) - pairs;
  result.num_false = static_cast<int>(estimate.size()) - pairs;
  const double root = 1.0 / params_.order;
  const double missed = 0.5 * limit * result.num_missed;
  const double false_tracks = 0.5 * limit * result.num_false;
  result.localization = std::pow(localization, root);
  result.missed = std::pow(missed, root);
  result.false_tracks = std::pow(false_tracks, root);
  result.total = std::pow(localization + missed + false_tracks, root);
  return result;
}

}  // namespace lookout::tracking
