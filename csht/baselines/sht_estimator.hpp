#pragma once

#include <vector>

#include "csht/csht_params.hpp"
#include "csht/hough_space.hpp"
#include "csht/hough_window.hpp"
#include "csht/motion_estimator.hpp"
#include "csht/spatial_correlation.hpp"
#include "csht/vote_peaks.hpp"

namespace lookout::csht {

/// The baseline without clustering. Its votes are whole, so its cells are larger than those of `csht`, whose
/// Gaussian votes want a fine grid. Values: docs/csht.md.
struct ShtParams {
  int window_scans = 20;              ///< W, 3 to kMaxWindowScans. [Yan2018] section V.
  int first_estimate_scans = 3;       ///< Scans before the first estimate, 1 to window_scans.
  double intercept_step = 5.0 / 3.0;  ///< Of the grid, in the range sigma, > 0.
  double velocity_step = 1.4;         ///< Of the grid, in range sigma / half the window's duration, > 0.
  double threshold = 0.6;             ///< A peak has more than this share of the most votes, in (0, 1).
  double apart = 3.0;    ///< Cells nearer than this to a stronger peak belong to it [grid steps], >= 0.
  int max_targets = 50;  ///< Most peaks that are targets, the strongest, > 0.
};

/// Standard Hough transform: each peak of the north vote matrix above a threshold is a target, its east line
/// the strongest of the line samples near it. [Yan2018] section V, "SHT".
class ShtEstimator : public MotionEstimator {
 public:
  /// @throws std::invalid_argument on a parameter out of range.
  ShtEstimator(const ShtParams& params, const core::SonarParams& sonar);

  std::span<const core::MotionElement> update(const core::PosedScan& scan) override;
  core::EstimatorMethod method() const override { return core::EstimatorMethod::sht; }
  int window_scans() const override { return params_.window_scans; }

 private:
  void find_peaks();
  void report(const VoteCell& peak);

  ShtParams params_;
  HoughWindow window_;
  HoughSpace north_votes_;
  SpatialCorrelation correlation_;
  double epoch_ = 0.0;
  std::vector<VoteCell> cells_;
  std::vector<VoteCell> peaks_;
  std::vector<core::MotionElement> elements_;
};

}  // namespace lookout::csht
