#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace lookout::tracking {

/// One measured position, in a plane frame of the caller's choice (earth, or local to the sensor).
struct Plot {
  int scan = 0;                    ///< Index of its scan in the window, 0 the oldest.
  double time = 0.0;               ///< Of its scan [s].
  Eigen::Vector2d position{0, 0};  ///< [m].
  Eigen::Matrix2d noise =
      Eigen::Matrix2d::Identity();  ///< Covariance of `position` [m^2], positive definite.
  /// Mean number of false plots per area around it [1/m^2], >= 0; 0 where unknown (methods that need it then
  /// take the window's own mean).
  double clutter_density = 0.0;
  int source = -1;  ///< The caller's own number of it, carried along.
};

/// The plots of some consecutive scans, in order of time. Memory is kept when it is cleared.
class PlotWindow {
 public:
  void clear();  ///< Forgets all scans and keeps the memory.
  /// Opens the next scan, which may stay empty. @throws std::invalid_argument unless `time` [s] is finite and
  /// later than that of the scan before.
  void begin_scan(double time);
  /// Adds a plot to the newest scan; its `scan` and `time` are set here. @throws std::invalid_argument where
  /// its position is not finite or no scan is open.
  void add(const Plot& plot);
  void drop_oldest_scan();  ///< Forgets the oldest scan and renumbers the plots; there must be one.

  int num_scans() const { return static_cast<int>(times_.size()); }  ///< Scans, empty ones included.
  int num_plots() const { return static_cast<int>(plots_.size()); }  ///< Plots of all scans.
  /// Time of a scan [s]; 0 <= scan < num_scans().
  double time(int scan) const { return times_[static_cast<std::size_t>(scan)]; }
  /// 0 <= index < num_plots().
  const Plot& plot(int index) const { return plots_[static_cast<std::size_t>(index)]; }
  /// In order of their scans; valid until the window changes.
  std::span<const Plot> plots() const { return plots_; }
  int first(int scan) const { return first_[static_cast<std::size_t>(scan)]; }  ///< Index of its first plot.
  int end(int scan) const;                                                      ///< One past its last plot.
  int size(int scan) const { return end(scan) - first(scan); }                  ///< Plots of a scan.
  /// The plots of one scan; valid until the window changes.
  std::span<const Plot> scan(int scan) const {
    return plots().subspan(as_size(first(scan)), as_size(size(scan)));
  }

 private:
  static std::size_t as_size(int value) { return static_cast<std::size_t>(value); }

  std::vector<double> times_;
  std::vector<int> first_;
  std::vector<Plot> plots_;
};

/// Area of the smallest upright box around all plots [m^2], at least 1; a thin box counts as a quarter as
/// wide as it is long.
double covered_area(const PlotWindow& window);

/// Half of a range of rho that holds every plot: the largest distance from the origin [m], at least 1.
double largest_distance(const PlotWindow& window);

}  // namespace lookout::tracking
