#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "tracking/initiation/lines/line_geometry.hpp"
#include "tracking/initiation/plots/gate_shapes.hpp"
#include "tracking/initiation/plots/plot_index.hpp"
#include "tracking/initiation/plots/plot_window.hpp"

namespace lookout::tracking {

/// A temporary track: two plots of consecutive scans and the line through them. [Fan2018] Eq. (9), (10).
struct PairPoint {
  int older = 0;        ///< Index of the plot in the window.
  int newer = 0;        ///< Index of the later plot in the window.
  NormalLine line;      ///< Through both plots.
  double weight = 1.0;  ///< How strongly it votes.
};

/// Forms the temporary tracks between the scans of a window.
class PairFormation {
 public:
  /// @param max_pairs the most that one window may have: bounds time and memory.
  /// @param margin by which the speed limits are widened [m], >= 0; 0 in [Fan2018].
  PairFormation(const SpeedLimits& speeds, std::int64_t max_pairs, double margin = 0.0);

  /// Starts a new window.
  void restart() { total_ = 0; }
  /// All pairs of a plot of scan - 1 and one of `scan` that the speeds allow, relative to `origin`;
  /// coinciding plots form none. Without a finite speed limit that is every pair. [Fan2018] Eq. (20).
  /// @return valid until the next call; incomplete once `exceeded()`.
  const std::vector<PairPoint>& form(const PlotWindow& window, int scan, const Eigen::Vector2d& origin);
  bool exceeded() const { return total_ > max_pairs_; }  ///< Whether there were more than the bound.
  /// What to tell the user of a window that has too many pairs.
  std::string refusal() const;

 private:
  void add(const PlotWindow& window, int older, int newer, const Eigen::Vector2d& origin);

  SpeedLimits speeds_;
  std::int64_t max_pairs_;
  double margin_;
  std::int64_t total_ = 0;
  PlotIndex index_;
  std::vector<PairPoint> pairs_;
};

/// Sorts pairs by theta, so that those near a line are found without a look at the rest.
void sort_by_theta(std::vector<PairPoint>& pairs);

/// Calls visit(pair, its line relative to `line`) for every pair whose line lies within both reaches of
/// `line`, over the ends of theta too. @param pairs sorted by theta. @param theta_reach below pi/2 [rad].
/// @param rho_reach [m].
template <typename Visit>
void for_pairs_near(const std::vector<PairPoint>& pairs, const NormalLine& line, double theta_reach,
                    double rho_reach, Visit&& visit) {
  for (const double turn : {-std::numbers::pi, 0.0, std::numbers::pi}) {
    const double low = line.theta + turn - theta_reach;
    auto pair = std::lower_bound(pairs.begin(), pairs.end(), low,
                                 [](const PairPoint& p, double theta) { return p.line.theta < theta; });
    for (; pair != pairs.end() && pair->line.theta <= low + 2.0 * theta_reach; ++pair) {
      const NormalLine apart = line_difference(pair->line, line);
      if (std::abs(apart.rho) <= rho_reach) visit(*pair, apart);
    }
  }
}

}  // namespace lookout::tracking
