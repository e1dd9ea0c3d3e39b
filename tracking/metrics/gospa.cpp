#include "tracking/metrics/gospa.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace lookout::tracking {

Gospa::Gospa(const OspaParams& params) : params_(Ospa(params).params()) {
  if (std::isinf(params.order)) throw std::invalid_argument("GOSPA order must be finite, got inf");
}

GospaResult Gospa::operator()(std::span<const Eigen::Vector2d> truth,
                              std::span<const Eigen::Vector2d> estimate) {
  distance_.resize(static_cast<Eigen::Index>(truth.size()), static_cast<Eigen::Index>(estimate.size()));
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (std::size_t j = 0; j < estimate.size(); ++j)
      distance_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          std::min(params_.cutoff, (truth[i] - estimate[j]).norm());
  // A pair at the cut-off costs what its two halves cost unpaired, so that pairing all of the smaller set is
  // best.
  std::vector<double> pairs;
  if (!truth.empty() && !estimate.empty()) {
    assignment_.solve(distance_, params_.order);
    std::copy_if(assignment_.paired().begin(), assignment_.paired().end(), std::back_inserter(pairs),
                 [this](double distance) { return distance < params_.cutoff; });
  }
  GospaResult result;
  result.num_missed = static_cast<int>(truth.size() - pairs.size());
  result.num_false = static_cast<int>(estimate.size() - pairs.size());
  const double root = 1.0 / params_.order;
  result.localization = power_norm(pairs, params_.order);
  result.missed = params_.cutoff * std::pow(0.5 * result.num_missed, root);
  result.false_tracks = params_.cutoff * std::pow(0.5 * result.num_false, root);
  result.total =
      power_norm(std::array{result.localization, result.missed, result.false_tracks}, params_.order);
  return result;
}

}  // namespace lookout::tracking
