#pragma once

#include <optional>
#include <vector>

#include "csht/fuzzy_isodata.hpp"
#include "csht/hough_space.hpp"
#include "csht/hough_window.hpp"
#include "csht/motion_estimator.hpp"
#include "csht/vote_peaks.hpp"

namespace lookout::csht {

/// Parameters of the printed algorithm. Where the paper gives no value, one value serves all cells.
struct CshtPrintedParams {
  int window_scans = 20;         ///< W, 3 to kMaxWindowScans. [Yan2018] section V.
  int first_estimate_scans = 3;  ///< Scans before the first estimate, 1 to window_scans.
  double intercept_step = 5.0;   ///< h_n0 [m], > 0.
  double velocity_step = 0.1;    ///< h_v [m/s], > 0.
  /// Of the cells that are clustered. [Yan2018] Eq. (17).
  PrimaryThresholdParams threshold{.peak_share = 0.35, .floor = 0.0, .mean_factor = 2.0, .mean_root = 0.0};
  /// Of the clustering. [Yan2018] section III.
  FuzzyIsodataParams isodata{.fuzzifier = 2.5,
                             .core_membership = 0.3,
                             .aggregation = 0.7,
                             .combination = 0.4,
                             .division_spread = 2.0,
                             .division_step = 1.0,
                             .deletion = 0.05};
  int first_classes = 6;  ///< Spread evenly over the kept cells, > 0.
  bool own_time = false;  ///< Eq. (41) with the north line at each detection's own time, not now.
};

/// The clustering statistic Hough transform as printed: raw votes in one cell each, intercepts at the start
/// of the window, features in m and m/s as they are, every detection given to the target whose *current*
/// north position is nearest (Eq. (41)), each target's east line by the same clustering from a single class,
/// no refit, no test of the count. [Yan2018] section III. A baseline: its values fit the paper's scene alone.
class CshtPrintedEstimator : public MotionEstimator {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  CshtPrintedEstimator(const CshtPrintedParams& params, const core::SonarParams& sonar);

  std::span<const core::MotionElement> update(const core::PosedScan& scan) override;
  core::EstimatorMethod method() const override { return core::EstimatorMethod::csht_printed; }
  int window_scans() const override { return params_.window_scans; }

 private:
  void keep_cells(const HoughSpace& space, int axis);
  void spread_first_classes();
  void correlate();
  std::optional<Line> single_line();  ///< Of east_samples_.
  void report(const Line& north, const Line& east);

  CshtPrintedParams params_;
  HoughWindow window_;
  HoughSpace north_votes_;
  HoughSpace east_votes_;  ///< Of one target at a time.
  std::vector<VoteCell> cells_;
  WeightedPoints points_;
  std::vector<FeaturePoint> first_;
  FuzzyIsodata isodata_;
  std::vector<Line> classes_;  ///< North lines.
  std::vector<int> class_of_;
  std::vector<LineSample> east_samples_;
  std::vector<core::MotionElement> elements_;
};

}  // namespace lookout::csht
