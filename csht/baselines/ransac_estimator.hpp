#pragma once

#include <cstdint>
#include <vector>

#include "core/detection.hpp"
#include "core/sonar_params.hpp"
#include "csht/motion_estimator.hpp"

namespace lookout::csht {

/// Parameters of RansacEstimator.
struct RansacParams {
  int window_scans = 20;         ///< Scans in a full window, >= 3. [Yan2018] W.
  int first_estimate_scans = 3;  ///< Scans before the first estimate, 1 to window_scans.
  double threshold = 1.0;        ///< Farthest detection of a line, in range sigmas, > 0.
  double support_share =
      0.3;              ///< Least detections of a line, as a share of the scans in the window, in (0, 1].
  int min_support = 5;  ///< ... and at least this many, >= 3.
  int max_lines = 20;   ///< Lines taken from a window, >= 1.
  int max_draws = 500;  ///< Pairs of detections drawn for a line, >= 1.
};

/// The first thing that a newcomer to the problem would try: MRPT's RANSAC takes straight lines one by one
/// from the detections of the window in the plane, time plays no part in the search, and a regression over
/// time along each line gives the motion. A baseline.
class RansacEstimator : public MotionEstimator {
 public:
  /// @throws std::invalid_argument showing the value that is out of range.
  RansacEstimator(const RansacParams& params, const core::SonarParams& sonar, std::uint64_t seed);

  std::span<const core::MotionElement> update(const core::PosedScan& scan) override;
  core::EstimatorMethod method() const override { return core::EstimatorMethod::ransac; }
  int window_scans() const override { return params_.window_scans; }

 private:
  void take_scan(const core::PosedScan& scan);
  std::vector<std::size_t> best_line(const std::vector<core::Detection>& points);
  void report(const std::vector<core::Detection>& own);

  RansacParams params_;
  core::SonarParams sonar_;
  std::uint64_t seed_;
  std::int64_t sequence_ = 0;
  std::vector<std::vector<core::Detection>> window_;  ///< Oldest scan first.
  std::int64_t newest_utime_ = 0, oldest_utime_ = 0;
  std::vector<std::int64_t> utimes_;
  std::vector<core::MotionElement> elements_;
};

}  // namespace lookout::csht
