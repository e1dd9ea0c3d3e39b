#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "tracking/association/assignment.hpp"
#include "tracking/track_before_detect/images/cell_target_tracker.hpp"
#include "tracking/track_before_detect/images/matched_filter.hpp"

namespace lookout::tracking {

/// Where the baselines find their points.
enum class PeakDetector {
  matched_filter,  ///< Local maxima of the matched-filtered frame above a threshold.
  cell_cfar  ///< Local maxima of the frame itself above the mean of cells near in range (cell averaging).
};

/// Detect first, then track: the baselines of track-before-detect. Threshold, counts, variances and density
/// were chosen on development seeds 301 and 302: the most time in track at 8 dB at about .04 false tracks a
/// scan.
struct PeakTrackerParams {
  PeakDetector detector = PeakDetector::matched_filter;  ///< What makes a peak.
  MatchedFilterParams filter;  ///< Of PeakDetector::matched_filter, and the neighbourhood of both.
  double threshold = 2.2;      ///< Filtered amplitude [background level], or ratio to the mean, > 0.
  int guard_cells = 4;         ///< Of the cell-averaging window, either side along columns, >= 0.
  int reference_cells = 12;    ///< Either side beyond the guard, >= 1.
  bool between_cells = true;   ///< Whether a peak's place is interpolated; else its cell's centre.
  Eigen::Vector2d measurement_sigma{0.45, 0.4};  ///< Of a peak's position [cells], > 0.
  double acceleration_density = 0.0005;          ///< [position unit^2 / s^3], > 0.
  double start_speed_sigma = 1.0;                ///< [unit/s], > 0.
  double max_speed = 4.0;                        ///< [unit/s], > 0.
  double gate = 9.21;                            ///< Chi-square gate at two degrees of freedom, > 0.
  int confirm_hits = 4;    ///< Hits among the first confirm_window frames that confirm, >= 1.
  int confirm_window = 6;  ///< >= confirm_hits.
  int max_misses = 5;      ///< Frames without a peak in a row that end a confirmed track, >= 1.
  int max_tracks = 300;    ///< >= 1.
};

/// The parameters of the registry's `mf_nn` and `cfar_nn`.
PeakTrackerParams matched_filter_baseline();
PeakTrackerParams cfar_baseline();  ///< Cell-averaging constant false-alarm rate.

/// Peaks, global nearest neighbours, a Kalman filter and M-of-N logic.
class PeakTracker : public CellTargetTracker {
 public:
  /// @throws std::invalid_argument naming the parameter out of range.
  explicit PeakTracker(const PeakTrackerParams& params);

  const std::vector<CellTrack>& update(const IntensityFrame& frame, const CellGeometry& geometry,
                                       double time) override;
  void reset() override;

 private:
  struct Life {
    int hits = 0;
    int misses = 0;  ///< In a row.
  };
  void detect(const IntensityFrame& frame);
  void predict(double time);
  void associate(const CellGeometry& geometry, double time);
  void correct(CellTrack& track, const CellView& view, const Eigen::Vector2d& measured) const;
  void confirm_and_end();
  void start_tracks(const CellGeometry& geometry, double time);
  Eigen::Matrix2d innovation_covariance(const CellTrack& track, const CellView& view) const;

  PeakTrackerParams params_;
  MatchedFilter filter_;
  AssignmentSolver solver_;
  IntensityFrame ratio_;  ///< Frame over the mean of its reference cells.
  std::vector<FramePeak> peaks_;
  std::vector<Eigen::Vector2d> places_;  ///< By peak [cells].
  std::vector<char> used_;
  std::vector<CellTrack> tracks_;
  std::vector<Life> lives_;
  double last_time_ = 0.0;
  std::int64_t next_id_ = 1;
};

/// Overwrites `ratio` with each cell of the frame over the mean of its reference cells along the row.
void cell_averaging_ratio(const IntensityFrame& frame, int guard_cells, int reference_cells,
                          IntensityFrame& ratio);

}  // namespace lookout::tracking
