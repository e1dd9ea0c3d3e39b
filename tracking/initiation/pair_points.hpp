#pragma once

#include <cstdint>
#include <vector>

#include "csht/line_geometry.hpp"
#include "tracking/initiation/gates.hpp"
#include "tracking/initiation/plot_index.hpp"
#include "tracking/initiation/plot_window.hpp"

namespace lookout::tracking {

/// A temporary track: two plots of consecutive scans and the line through them. [Fan2018] Eq. (9), (10).
struct PairPoint {
  int older = 0;  ///< Index of the plot in the window.
  int newer = 0;
  csht::NormalLine line;
};

/// Forms the temporary tracks between the scans of a window.
class PairFormation {
 public:
  /// @param max_pairs the most that one window may have: bounds time and memory.
  PairFormation(const SpeedLimits& speeds, std::int64_t max_pairs);

  /// Starts a new window.
  void restart() { total_ = 0; }
  /// All pairs of a plot of scan - 1 and one of `scan` that the speeds allow, relative to `origin`; coinciding
  /// plots form none. Without a finite speed limit that is every pair. [Fan2018] Eq. (20).
  /// @return valid until the next call; incomplete once `exceeded()`.
  const std::vector<PairPoint>& form(const PlotWindow& window, int scan, const Eigen::Vector2d& origin);
  bool exceeded() const { return total_ > max_pairs_; }
  /// What to tell the user of a window that has too many pairs.
  std::string refusal() const;

 private:
  void add(const PlotWindow& window, int older, int newer, const Eigen::Vector2d& origin);

  SpeedLimits speeds_;
  std::int64_t max_pairs_;
  std::int64_t total_ = 0;
  PlotIndex index_;
  std::vector<PairPoint> pairs_;
};

}  // namespace lookout::tracking
