#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tracking/track_before_detect/images/cell_geometry.hpp"
#include "tracking/track_before_detect/images/cell_measurement.hpp"
#include "tracking/track_before_detect/images/cell_target_tracker.hpp"
#include "tracking/track_before_detect/images/scale_space.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// How a target moves.
struct CellMotionParams {
  double steady_density = 0.0004;  ///< White acceleration on a steady course [unit^2 / s^3], > 0.
  double agile_density = 0.05;     ///< Where the innovations say that it turns [unit^2 / s^3], > 0.
  double start_speed_sigma = 1.0;  ///< Of each velocity component of a new track [unit/s], > 0.
  double max_speed = 4.0;          ///< Faster tracks are deleted [unit/s], > 0.
};

/// How a track comes to exist and ends.
struct CellExistenceParams {
  double birth_expectation = 5.0;    ///< Blocks a frame and scale that start tracks without a target, > 0.
  double births_per_frame = 8.0;     ///< Prior: targets expected to appear in a frame, > 0.
  double rank_exponent = 0.15;       ///< a: ranks of targets have density a p^(a - 1), in (0, 1).
  double least_probability = 1e-6;   ///< A block less probable than this says no more, in (0, 1).
  double lifetime = 25.0;            ///< Mean time that a target lasts [s], > 0.
  double confirm_existence = 0.995;  ///< In (0, 1).
  double most_existence = 0.99999;   ///< No track is surer, in (0, 1).
  int min_age = 2;                   ///< Frames after its first before a track is confirmed, >= 0.
  double delete_confirmed = 0.02;    ///< Existence below which a confirmed track ends.
  double delete_tentative = 1e-5;    ///< And a tentative one.
  double merge_distance = 1.5;       ///< Tracks nearer than this are one [signatures], >= 0.
  double birth_distance = 5.0;       ///< Peaks nearer to a track than this start none [signatures], >= 0.
  double sidelobe_ratio = 0.3;       ///< Peaks in a track's columns below this share of it start none, >= 0.
  double coast = 10.0;               ///< How long a confirmed track outside the image is kept [s], >= 0.
  double leave_out_existence = 0.9;  ///< Above it (and once confirmed) a target's blocks are no background.
  int max_births = 64;               ///< Of a frame, >= 1.
  int max_tracks = 300;              ///< >= 1.
};

/// What stands over ground is background.
struct CellStandingParams {
  bool judged = true;         ///< Whether standing tracks are told from moving ones at all.
  double moving_odds = 5.0;   ///< Prior odds that a new track moves, > 0.
  double known_odds = 0.02;   ///< The same where something was found to stand before, > 0.
  double speed_sigma = 1.5;   ///< Of either velocity component of what moves [unit/s], > 0.
  double least_moving = 0.3;  ///< Probability of moving below which a track counts as standing, in (0, 1).
  int min_age = 4;            ///< Frames before that is judged, >= 1.
  int early_frames = 6;       ///< Frames from the first, of which all that stands is new, >= 0.
  int early_age = 15;         ///< Age at which tracks that began then are judged, >= 1.
  double memory = 60.0;       ///< How long a standing place is known [s], > 0.
};

/// Of the filter, nested by step.
struct CellTrackerParams {
  ScaleSpaceParams scales;            ///< Which signatures are looked for.
  CellMeasurementParams measurement;  ///< How a target is measured.
  CellMotionParams motion;            ///< How a target moves.
  CellExistenceParams existence;      ///< When a target is believed.
  CellStandingParams standing;        ///< What is no target.
};

/// @throws std::invalid_argument naming the parameter out of range.
void check(const CellTrackerParams& params);

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
  struct StandingPlace {
    Eigen::Vector2d position;
    double time;
  };
  struct GatedCandidate {
    std::size_t candidate;
    double cost;  ///< -ln of how probable it is, but for a constant.
  };
  void predict(double time);
  void look(const IntensityFrame& frame, const CellGeometry& geometry);
  void choose_starts(const CellGeometry& geometry);
  void branch(const CellTrack& track, std::size_t candidate);
  Eigen::Vector2d choose_start(const CellGeometry& geometry, std::size_t k);
  void gate_candidates(const Eigen::Vector2d& cell, const Eigen::Matrix2d& S_inverse, bool confirmed);
  double likelihood_ratio(const CellGeometry& geometry, const CellTrack& track,
                          const Eigen::Vector2d& start) const;
  double mean_ratio(const CellTrack& track, const CellView& view, const Eigen::Vector2d& start) const;
  void judge(const CellGeometry& geometry, double time);
  void judge_existence(CellTrack& track, double ratio, double time) const;
  void set_systematic(CellTrack& track, const CellView& view) const;
  void judge_scale(CellTrack& track, const CellView& view) const;
  void judge_motion(CellTrack& track, const CellView& view, double time) const;
  double way_ratio(const Eigen::Vector2d& way, const Eigen::Matrix2d& standing) const;
  double motion_ratio(const Eigen::Vector2d& v, const Eigen::Matrix2d& standing) const;
  double log_ratio(double log_probability) const;
  void confirm(CellTrack& track) const;
  void end_tracks(double time);
  bool stands(const CellTrack& track) const;
  void merge(const CellGeometry& geometry);
  bool same(const CellTrack& a, const CellTrack& b, const CellGeometry& geometry) const;
  void start_tracks(const CellGeometry& geometry, double time);
  CellTrack new_track(const CellGeometry& geometry, const Candidate& candidate, double time);
  bool belongs_to(const CellTrack& track, const CellGeometry& geometry, const Candidate& peak) const;
  bool is_taken(const CellGeometry& geometry, const Candidate& peak) const;
  Candidate peak_at(const Eigen::Vector2d& cell, int scale) const;
  bool at_a_standing_place(const CellGeometry& geometry, const Candidate& candidate) const;
  void claim_standing(const CellGeometry& geometry);
  void claim_targets(const CellGeometry& geometry);
  CellWindow window_of(const CellTrack& track, const CellGeometry& geometry) const;

  CellTrackerParams params_;
  ScaleSpace scales_;
  CellMeasurement measurement_;
  std::vector<CellTrack> tracks_;
  std::vector<Eigen::Vector2d> starts_;    ///< By track, where its intensity is looked for.
  std::vector<Eigen::Vector2d> branched_;  ///< Starts of tracks that branched off.
  std::vector<double> ratios_;             ///< By track, of likelihoods with and without it.
  std::vector<CellWindow> windows_;        ///< Around confirmed tracks.
  std::vector<Candidate> candidates_;
  std::vector<char> taken_;  ///< By candidate, whether it belongs to a confirmed track.
  std::vector<GatedCandidate> gated_;
  std::vector<CellTrack> born_;
  std::vector<char> merged_;
  std::vector<StandingPlace> places_;
  CellClaims claims_;
  double last_time_ = 0.0;
  double learnt_time_ = 0.0;  ///< Tracks before it began while the background was unknown [s].
  int frames_ = 0;
  std::int64_t next_id_ = 1;
};

}  // namespace lookout::tracking
