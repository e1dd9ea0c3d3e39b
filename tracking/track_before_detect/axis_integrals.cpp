#include "tracking/track_before_detect/axis_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

/// Below this an integral along an axis counts as 0: products of two would be denormal numbers, on which a
/// processor takes a hundred times as long.
constexpr double kNegligible = 1e-150;

/// One edge of a cell in standard units.
struct Edge {
  double u = 0.0;        ///< (edge - mean) / sigma.
  double tail = 0.0;     ///< Mass beyond the edge on the edge's own side of the mean.
  double density = 0.0;  ///< Standard density at u.
};

double tail_of(double u) {
  return 0.5 * std::erfc(std::abs(u) / std::numbers::sqrt2);
}

double density_of(double u) {
  constexpr double kScale = 0.5 * std::numbers::sqrt2 * std::numbers::inv_sqrtpi;
  return kScale * std::exp(-0.5 * u * u);
}

Edge edge_at(double u) {
  return {u, tail_of(u), density_of(u)};
}

/// Mass between two edges. Both on one side of the mean: the difference of the small tails, so that nothing
/// cancels.
double mass_between(double u_low, double tail_low, double u_high, double tail_high) {
  if (u_low >= 0.0) return std::max(0.0, tail_low - tail_high);
  if (u_high <= 0.0) return std::max(0.0, tail_high - tail_low);
  return 1.0 - tail_low - tail_high;
}

CellIntegrals integrals_between(const Edge& low, const Edge& high, double sigma, CellMoments moments) {
  CellIntegrals cell;
  cell.probability = mass_between(low.u, low.tail, high.u, high.tail);
  cell.first = sigma * (low.density - high.density);
  if (moments == CellMoments::first) return cell;
  cell.second =
      std::max(0.0, sigma * sigma * (cell.probability + low.u * low.density - high.u * high.density));
  return cell;
}

}  // namespace

CellIntegrals integrate_cell(double mean, double variance, double low, double high) {
  const double sigma = std::sqrt(variance);
  return integrals_between(edge_at((low - mean) / sigma), edge_at((high - mean) / sigma), sigma,
                           CellMoments::second);
}

double cell_probability(double mean, double variance, double low, double high) {
  const double sigma = std::sqrt(variance);
  const double u_low = (low - mean) / sigma, u_high = (high - mean) / sigma;
  return mass_between(u_low, tail_of(u_low), u_high, tail_of(u_high));
}

double cell_first_moment(double mean, double variance, double low, double high) {
  const double sigma = std::sqrt(variance);
  return sigma * (density_of((low - mean) / sigma) - density_of((high - mean) / sigma));
}

double cell_second_moment(double mean, double variance, double low, double high) {
  return integrate_cell(mean, variance, low, high).second;
}

void AxisIntegrals::compute(double mean, double variance, int first_cell, int num_cells,
                            CellMoments moments) {
  const auto size = static_cast<std::size_t>(num_cells);
  for (auto* integrals : {&probability_, &first_, &second_}) integrals->resize(size);
  sum_ = {};
  const double sigma = std::sqrt(variance);
  Edge low = edge_at((first_cell - mean) / sigma);
  for (std::size_t i = 0; i < size; ++i) {
    const Edge high = edge_at((first_cell + static_cast<double>(i) + 1.0 - mean) / sigma);
    CellIntegrals cell = integrals_between(low, high, sigma, moments);
    if (cell.probability < kNegligible) cell = {};
    probability_[i] = cell.probability;
    first_[i] = cell.first;
    second_[i] = cell.second;
    sum_.probability += cell.probability;
    sum_.first += cell.first;
    sum_.second += cell.second;
    low = high;
  }
}

}  // namespace lookout::tracking
