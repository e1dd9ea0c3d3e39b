#include "csht/vote_peaks.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/parameter_check.hpp"

namespace lookout::csht {

void PrimaryThresholdParams::validate() const {
  core::require_share_below_one("peak_share", peak_share);
  core::require_not_negative("floor", floor);
  core::require_not_negative("mean_factor", mean_factor);
  core::require_not_negative("mean_root", mean_root);
}

double primary_threshold(const PrimaryThresholdParams& params, const VoteStatistics& statistics) {
  return std::max({params.peak_share * statistics.peak, params.floor,
                   params.mean_factor * statistics.mean + params.mean_root * std::sqrt(statistics.mean)});
}

double steps_apart(const VoteCell& a, const VoteCell& b, const HoughGrid& grid) {
  return std::hypot((a.velocity - b.velocity) / grid.velocity_step,
                    (a.intercept - b.intercept) / grid.intercept_step);
}

void sort_by_votes(std::span<VoteCell> cells) {
  std::sort(cells.begin(), cells.end(), [](const VoteCell& a, const VoteCell& b) {
    return std::tuple(-a.votes, a.velocity, a.intercept) < std::tuple(-b.votes, b.velocity, b.intercept);
  });
}

void strongest_apart(std::span<const VoteCell> cells, const HoughGrid& grid, double min_steps, int max_peaks,
                     std::vector<VoteCell>& peaks) {
  peaks.clear();
  for (const auto& cell : cells) {
    if (static_cast<int>(peaks.size()) >= max_peaks) return;
    const bool apart = std::all_of(peaks.begin(), peaks.end(), [&](const VoteCell& peak) {
      return steps_apart(cell, peak, grid) >= min_steps;
    });
    if (apart) peaks.push_back(cell);
  }
}

}  // namespace lookout::csht
