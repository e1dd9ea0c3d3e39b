#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tracking/track_before_detect/images/cell_evidence.hpp"
#include "tracking/track_before_detect/images/cell_geometry.hpp"
#include "tracking/track_before_detect/images/cell_measurement.hpp"
#include "tracking/track_before_detect/images/cell_peaks.hpp"
#include "tracking/track_before_detect/images/cell_standing.hpp"
#include "tracking/track_before_detect/images/cell_target_tracker.hpp"
#include "tracking/track_before_detect/images/cell_tracker_params.hpp"
#include "tracking/track_before_detect/images/scale_space.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// The multi-target track-before-detect filter on frames whose background is about 1: predicts, measures in
/// the cells of each target's scale, judges existence and motion, ends, confirms and starts tracks.
class CellTracker : public CellTargetTracker {
 public:
  /// @throws std::invalid_argument naming the parameter out of range.
  explicit CellTracker(const CellTrackerParams& params = {});

  /// Takes the frame at `time` [s]; times increase. The tracks stay valid until the next call.
  const std::vector<CellTrack>& update(const IntensityFrame& frame, const CellGeometry& geometry,
                                       double time) override;

  const std::vector<CellTrack>& tracks() const { return tracks_; }  ///< Valid until the next update.
  const CellClaims* claims() const override { return &claims_; }
  void reset() override;  ///< Forgets all tracks; ids go on.

 private:
  void predict(double time);
  void look(const IntensityFrame& frame, const CellGeometry& geometry);
  void change_scales(const CellGeometry& geometry);
  void choose_starts(const CellGeometry& geometry);
  double likelihood_ratio(const CellGeometry& geometry, const CellTrack& track,
                          const Eigen::Vector2d& start) const;
  void judge(const CellGeometry& geometry, double time);
  bool is_whole(const CellTrack& track, const CellView& view) const;
  void set_systematic(CellTrack& track, const CellView& view) const;
  void confirm(CellTrack& track) const;
  void end_tracks(double time);
  void merge(const CellGeometry& geometry);
  bool same(const CellTrack& a, const CellTrack& b, const CellGeometry& geometry) const;
  void start_tracks(const CellGeometry& geometry, double time);
  CellTrack new_track(const CellGeometry& geometry, const Candidate& candidate, double time);
  void claim_standing(const CellGeometry& geometry);
  void claim_targets(const CellGeometry& geometry, double probability,
                     std::vector<CellWindow>& windows) const;
  CellWindow window_of(const CellTrack& track, const CellGeometry& geometry) const;

  CellTrackerParams params_;
  Eigen::Array2d frame_size_{0.0, 0.0};  ///< Columns, rows of the frame at hand.
  ScaleSpace scales_;
  CellPeaks peaks_;
  CellMeasurement measurement_;
  CellEvidence evidence_;
  CellStanding standing_;
  std::vector<CellTrack> tracks_;
  std::vector<Eigen::Vector2d> starts_;  ///< By track, where its intensity is looked for.
  std::vector<double> ratios_;           ///< By track, of likelihoods with and without it.
  std::vector<CellWindow> windows_;      ///< Around confirmed tracks.
  std::vector<CellTrack> born_;
  std::vector<char> merged_;
  CellClaims claims_;
  double last_time_ = 0.0;
  double step_ = 0.0;  ///< To the frame at hand [s]; infinite to the first.
  bool started_ = false;
  std::int64_t next_id_ = 1;
};

}  // namespace lookout::tracking
