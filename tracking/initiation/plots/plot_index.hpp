#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "tracking/initiation/plots/plot_window.hpp"

namespace lookout::tracking {

/// A grid over the plots of one scan with about one plot a cell, so that a gate looks at its own
/// neighbourhood and not at the whole scan.
class PlotIndex {
 public:
  /// Sorts the plots of `scan` into cells. The window must not change while the index is in use.
  void build(const PlotWindow& window, int scan);

  /// Calls visit(index of plot) for every plot within `radius` [m] of `centre`, and for some just beyond.
  template <typename Visit>
  void near(const Eigen::Vector2d& centre, double radius, Visit&& visit) const {
    if (plots_.empty()) return;
    const int left = column(centre.x() - radius);
    const int right = column(centre.x() + radius);
    const int top = row(centre.y() + radius);
    for (int j = row(centre.y() - radius); j <= top; ++j) {
      const std::size_t line = static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_);
      const int first = starts_[line + static_cast<std::size_t>(left)];
      const int end = starts_[line + static_cast<std::size_t>(right) + 1];
      for (int i = first; i < end; ++i) visit(plots_[static_cast<std::size_t>(i)]);
    }
  }

 private:
  int column(double x) const { return clamped((x - low_.x()) / cell_.x(), columns_); }
  int row(double y) const { return clamped((y - low_.y()) / cell_.y(), rows_); }
  static int clamped(double value, int count) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(count - 1)));
  }
  std::size_t cell_of(const Eigen::Vector2d& p) const {
    return static_cast<std::size_t>(row(p.y())) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column(p.x()));
  }

  Eigen::Vector2d low_{0, 0};
  Eigen::Vector2d cell_{1, 1};
  int columns_ = 1;
  int rows_ = 1;
  std::vector<int> starts_;  ///< First entry of `plots_` of each cell, and one past the last.
  std::vector<int> plots_;   ///< Indices of plots, cell by cell.
};

}  // namespace lookout::tracking
