#pragma once

#include <span>
#include <vector>

#include "csht/hough_space.hpp"

namespace lookout::csht {

/// The primary threshold lambda of [Yan2018] Eq. (17): the largest of four readings of "clearly more votes
/// than the rest".
struct PrimaryThresholdParams {
  double peak_share = 0.4;   ///< Share of the most votes, in [0, 1).
  double floor = 1.5;        ///< Votes, >= 0.
  double mean_factor = 1.0;  ///< Of the mean over the filled cells, >= 0.
  double mean_root = 0.5;  ///< Of that mean's square root (its Poisson spread), >= 0; carries heavy clutter.

  /// @throws std::invalid_argument naming the value out of range.
  void validate() const;
};

/// lambda for a vote matrix of these statistics [votes].
double primary_threshold(const PrimaryThresholdParams& params, const VoteStatistics& statistics);

/// Distance of two cells in grid steps.
double steps_apart(const VoteCell& a, const VoteCell& b, const HoughGrid& grid);

/// Sorts `cells` by falling votes (ties by velocity and intercept, so that the order is one).
void sort_by_votes(std::span<VoteCell> cells);

/// The peaks among sorted `cells`: by falling votes, each at least `min_steps` grid steps from those before
/// it, at most `max_peaks`. Overwrites `peaks`.
void strongest_apart(std::span<const VoteCell> cells, const HoughGrid& grid, double min_steps, int max_peaks,
                     std::vector<VoteCell>& peaks);

}  // namespace lookout::csht
