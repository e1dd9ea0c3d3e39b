#pragma once

#include <span>
#include <vector>

#include "tracking/initiation/lines/line_grid.hpp"

namespace lookout::tracking {

/// A cell of a line accumulator and what it holds.
struct LineVote {
  LineCell cell;       ///< Its column and row.
  double value = 0.0;  ///< Votes.
  int layer = 0;       ///< Index along a third axis (speed); 0 where there is none.
};

/// Whether none of the eight cells around a vote's holds more, over the ends of theta too.
/// @param votes_of(cell) what a cell on the grid holds.
template <class VotesOf>
bool is_local_maximum(const LineGrid& grid, const LineVote& vote, const VotesOf& votes_of) {
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      const LineCell beside = grid.wrapped({vote.cell.theta + i, vote.cell.rho + j});
      if (grid.contains(beside) && votes_of(beside) > vote.value) return false;
    }
  }
  return true;
}

/// Which candidates count as one peak.
struct PeakParams {
  int theta_radius = 1;   ///< Columns around a peak that it suppresses, >= 0.
  int rho_radius = 1;     ///< Rows around a peak that it suppresses, >= 0.
  int layer_radius = 0;   ///< Layers around a peak that it suppresses, >= 0.
  int max_peaks = 10000;  ///< The strongest that are kept, >= 1: bounds the time, (candidates x peaks).
};

/// Non-maximum suppression over the wrapped line grid: the strongest candidate is a peak and removes all
/// within its radii; of the rest again. Equal values: the lower cell number and layer first.
/// @param candidates is put into another order; the peaks come first.
/// @return the peaks, strongest first, at the front of `candidates`.
std::span<const LineVote> strongest_peaks(const LineGrid& grid, const PeakParams& params,
                                          std::vector<LineVote>& candidates);

}  // namespace lookout::tracking
