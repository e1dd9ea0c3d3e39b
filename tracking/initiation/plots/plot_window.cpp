#include "tracking/initiation/plots/plot_window.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace lookout::tracking {
namespace {

/// A box thinner than this share of its length is that of a few plots in a row, not of a narrow field.
constexpr double kLeastAspect = 0.25;

}  // namespace

void PlotWindow::clear() {
  times_.clear();
  first_.clear();
  plots_.clear();
}

void PlotWindow::begin_scan(double time) {
  if (!std::isfinite(time) || (!times_.empty() && time <= times_.back()))
    throw std::invalid_argument("a scan must be later than the one before, got time " + std::to_string(time));
  times_.push_back(time);
  first_.push_back(num_plots());
}

void PlotWindow::add(const Plot& plot) {
  if (times_.empty()) throw std::invalid_argument("a plot needs an open scan");
  if (!plot.position.allFinite()) throw std::invalid_argument("a plot's position must be finite");
  plots_.push_back(plot);
  plots_.back().scan = num_scans() - 1;
  plots_.back().time = times_.back();
}

void PlotWindow::drop_oldest_scan() {
  if (times_.empty()) return;
  const int gone = size(0);
  plots_.erase(plots_.begin(), plots_.begin() + gone);
  times_.erase(times_.begin());
  first_.erase(first_.begin());
  for (int& first : first_) first -= gone;
  for (Plot& plot : plots_) --plot.scan;
}

int PlotWindow::end(int scan) const {
  return scan + 1 < num_scans() ? first(scan + 1) : num_plots();
}

double covered_area(const PlotWindow& window) {
  if (window.num_plots() == 0) return 1.0;
  Eigen::Vector2d low = window.plot(0).position;
  Eigen::Vector2d high = low;
  for (const Plot& plot : window.plots()) {
    low = low.cwiseMin(plot.position);
    high = high.cwiseMax(plot.position);
  }
  const Eigen::Vector2d sides = high - low;
  const double longer = sides.maxCoeff();
  return std::max(1.0, longer * std::max(sides.minCoeff(), kLeastAspect * longer));
}

double largest_distance(const PlotWindow& window) {
  double largest = 1.0;
  for (const Plot& plot : window.plots()) largest = std::max(largest, plot.position.norm());
  return largest;
}

}  // namespace lookout::tracking
