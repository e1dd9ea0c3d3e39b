#include "tracking/initiation/lines/peak_extraction.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <tuple>

namespace lookout::tracking {

std::span<const LineVote> strongest_peaks(const LineGrid& grid, const PeakParams& params,
                                          std::vector<LineVote>& candidates) {
  assert(params.theta_radius >= 0 && params.rho_radius >= 0 && params.layer_radius >= 0 &&
         params.max_peaks >= 1);
  std::sort(candidates.begin(), candidates.end(), [&](const LineVote& a, const LineVote& b) {
    return std::tuple(-a.value, grid.index(a.cell), a.layer) <
           std::tuple(-b.value, grid.index(b.cell), b.layer);
  });
  const auto suppresses = [&](const LineVote& peak, const LineVote& other) {
    const LineCell apart = cell_distance(grid, peak.cell, other.cell);
    return apart.theta <= params.theta_radius && apart.rho <= params.rho_radius &&
           std::abs(peak.layer - other.layer) <= params.layer_radius;
  };
  std::size_t num_peaks = 0;
  for (const LineVote& candidate : candidates) {
    if (num_peaks >= static_cast<std::size_t>(params.max_peaks)) break;
    const auto end = candidates.begin() + static_cast<std::ptrdiff_t>(num_peaks);
    if (std::none_of(candidates.begin(), end,
                     [&](const LineVote& peak) { return suppresses(peak, candidate); }))
      candidates[num_peaks++] = candidate;
  }
  return {candidates.data(), num_peaks};
}

}  // namespace lookout::tracking
