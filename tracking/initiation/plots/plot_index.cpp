#include "tracking/initiation/plots/plot_index.hpp"

#include <cmath>

namespace lookout::tracking {

void PlotIndex::build(const PlotWindow& window, int scan) {
  const auto plots = window.scan(scan);
  plots_.assign(plots.size(), 0);
  if (plots.empty()) return;
  Eigen::Vector2d high = low_ = plots.front().position;
  for (const Plot& plot : plots) {
    low_ = low_.cwiseMin(plot.position);
    high = high.cwiseMax(plot.position);
  }
  columns_ = rows_ = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(plots.size()))));
  cell_ = ((high - low_) / columns_).cwiseMax(1e-9);
  starts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Plot& plot : plots) ++starts_[cell_of(plot.position) + 1];
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  // Filling from the back turns each cell's end into its start.
  for (int i = window.end(scan) - 1; i >= window.first(scan); --i) {
    int& end = starts_[cell_of(window.plot(i).position) + 1];
    plots_[static_cast<std::size_t>(--end)] = i;
  }
  // starts_[c + 1] is now the start of cell c: shift down and close the last.
  for (std::size_t i = 0; i + 1 < starts_.size(); ++i) starts_[i] = starts_[i + 1];
  starts_.back() = static_cast<int>(plots.size());
}

}  // namespace lookout::tracking
