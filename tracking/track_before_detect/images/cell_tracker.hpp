#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tracking/track_before_detect/axis_integrals.hpp"
#include "tracking/track_before_detect/images/cell_geometry.hpp"
#include "tracking/track_before_detect/images/cell_target_tracker.hpp"
#include "tracking/track_before_detect/images/matched_filter.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// How a target's position is measured in the cells near it. Values: [Pakfiliz2018] in Poisson form with the
/// changes of docs/track_before_detect.md, chosen on development seeds at 8 dB.
struct CellMeasurementParams {
  Eigen::Vector2d sigma{1.1, 0.75};  ///< The instrument's signature along columns and rows [cells], > 0.
  int gate_columns = 17;             ///< Cells of the gate along columns, odd, >= 1.
  int gate_rows = 13;                ///< Along rows, odd, >= 1.
  int iterations = 3;                ///< EM iterations per frame, >= 1.
  double threshold = 1.9;            ///< Cells at or below are dark [background level], >= 0.
  double intensity_memory = 0.5;     ///< Share of the old intensity in the smoothed one, in [0, 1).
  double min_intensity = 0.5;        ///< Below it a frame measures nothing [background level], > 0.
  /// Variance of the measured centroid over sigma^2 / intensity, > 0: the cells' noise is not Poisson.
  double variance_factor = 2.4;
};

/// How a target moves.
struct CellMotionParams {
  double acceleration_density = 0.02;  ///< White acceleration [position unit^2 / s^3], > 0.
  double start_speed_sigma = 1.0;      ///< Of each velocity component of a new track [unit/s], > 0.
  double max_speed = 4.0;              ///< Faster tracks are deleted [unit/s], > 0.
};

/// How a track comes to exist and ends.
struct CellExistenceParams {
  double birth_quantile = 0.997;     ///< Peaks above this share of the tiling blocks start tracks, in (0, 1).
  double birth_existence = 0.3;      ///< In (0, 1).
  double rank_exponent = 0.15;       ///< a: ranks of targets have density a p^(a - 1), in (0, 1).
  double survival = 0.98;            ///< Per frame, in (0, 1].
  double confirm_existence = 0.995;  ///< In (0, 1).
  int min_age = 2;                   ///< Frames after its first before a track is confirmed, >= 0.
  double delete_tentative = 0.1;     ///< Existence below which a tentative track ends.
  double delete_confirmed = 0.02;    ///< And a confirmed one.
  double merge_distance = 1.5;       ///< Tracks nearer than this are one [cells], >= 0.
  double birth_distance = 4.0;       ///< Peaks nearer to a track than this start none [cells], >= 0.
  double sidelobe_ratio = 0.3;       ///< Peaks in a track's columns below this share of it start none, >= 0.
  double coast = 10.0;               ///< How long a confirmed track outside the image is kept [s], >= 0.
  double leave_out_existence = 0.9;  ///< Above it (and once confirmed) a target's blocks are no background.
  int max_tracks = 300;              ///< >= 1.
};

/// Of the filter, nested by step.
struct CellTrackerParams {
  CellMeasurementParams measurement;  ///< How a target is measured.
  CellMotionParams motion;            ///< How a target moves.
  CellExistenceParams existence;      ///< When a target is believed.
  MatchedFilterParams filter;         ///< Of the instrument's signature.
};

/// @throws std::invalid_argument naming the parameter out of range.
void check(const CellTrackerParams& params);

/// Measures the targets' positions in one frame by gated EM in Poisson form: target k gives lambda_k P_kl to
/// cell l, the background lambda_0; truncated cells are dark.
class CellMeasurement {
 public:
  /// The parameters must have been checked.
  explicit CellMeasurement(const CellMeasurementParams& params) : params_(params) {}

  /// Updates states, covariances and intensities of the tracks that are inside.
  void update(const IntensityFrame& frame, const CellGeometry& geometry, std::vector<CellTrack>& tracks);

  double background() const { return background_; }  ///< lambda_0 of the last frame.

 private:
  struct Cloud {
    bool active = false;
    Eigen::Vector4d predicted;
    Eigen::Matrix4d covariance;
    CellView view;           ///< At the predicted position.
    Eigen::Vector2d mean;    ///< Present estimate of the cell position.
    double intensity = 0.0;  ///< Present lambda_k.
    CellWindow gate;
    AxisIntegrals x, y;
    double next_intensity = 0.0;
    Eigen::Vector2d first{0, 0};
  };
  void start(const IntensityFrame& frame, const CellGeometry& geometry, const std::vector<CellTrack>& tracks);
  void open_gate(const IntensityFrame& frame, Cloud& cloud) const;
  void collect(const IntensityFrame& frame, std::size_t k);
  void correct(const CellGeometry& geometry, Cloud& cloud, CellTrack& track) const;
  double mean_displayed(const IntensityFrame& frame) const;

  CellMeasurementParams params_;
  double background_ = 0.0;
  std::vector<Cloud> clouds_;
  std::vector<DisplayedCell> cells_;
};

/// The multi-target track-before-detect filter on frames whose background is about 1: predicts, measures in
/// the cells, judges existence by rank, ends, confirms and starts tracks.
class CellTracker : public CellTargetTracker {
 public:
  /// @throws std::invalid_argument naming the parameter out of range.
  explicit CellTracker(const CellTrackerParams& params = {});

  /// Takes the frame at `time` [s]; times increase. The tracks stay valid until the next call.
  const std::vector<CellTrack>& update(const IntensityFrame& frame, const CellGeometry& geometry,
                                       double time) override;

  const std::vector<CellTrack>& tracks() const { return tracks_; }  ///< Valid until the next update.
  void reset() override;                                            ///< Forgets all tracks; ids go on.

 private:
  void predict(double time);
  void leave_out_confirmed(const CellGeometry& geometry);
  void judge(const CellGeometry& geometry, double time);
  double rank_of(const CellTrack& track, const CellView& view) const;
  void end_tracks(double time);
  void merge(const CellGeometry& geometry);
  void start_tracks(const CellGeometry& geometry, double time);
  bool belongs_to_a_track(const CellGeometry& geometry, const FramePeak& peak) const;

  CellTrackerParams params_;
  MatchedFilter filter_;
  CellMeasurement measurement_;
  std::vector<CellTrack> tracks_;
  std::vector<CellWindow> windows_;  ///< Around confirmed tracks.
  std::vector<FramePeak> peaks_;
  std::vector<char> merged_;
  double last_time_ = 0.0;
  std::int64_t next_id_ = 1;
};

}  // namespace lookout::tracking
