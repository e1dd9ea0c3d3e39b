#pragma once

#include <Eigen/Core>
#include <vector>

#include "tracking/track_before_detect/images/cell_geometry.hpp"
#include "tracking/track_before_detect/images/cell_target_tracker.hpp"
#include "tracking/track_before_detect/images/cell_tracker_params.hpp"
#include "tracking/track_before_detect/images/scale_space.hpp"

namespace lookout::tracking {

/// Tells tracks of what stands over ground from those of what moves, and remembers where something stood.
class CellStanding {
 public:
  /// The parameters must have been checked.
  explicit CellStanding(const CellStandingParams& params) : params_(params) {}

  /// Begins the frame at `time` [s].
  void begin(double time);
  /// Whether the track moves, by its velocity and by the way that it has made: on structure that glitters a
  /// track wanders to and fro within its signature. And whether it moves in the sonar's frame. Of what the
  /// frame's border cuts a part is measured, whose middle moves as more of it is seen: it is judged from when
  /// it is seen whole, or has been there for long.
  void judge_motion(const ScaleSpace& scales, const CellGeometry& geometry, double time,
                    CellTrack& track) const;
  /// Whether the track began in the first frames and has not had the time to show what it is.
  bool is_early(const CellTrack& track) const;
  /// Whether the track counts as standing.
  bool stands(const CellTrack& track) const;
  /// The same, and it is old enough to be given up for it.
  bool surely_stands(const CellTrack& track) const { return stands(track) && track.age >= params_.min_age; }
  /// Whether the border cuts the track, or it goes along with the sonar and has not done so for long: a mark
  /// of the instrument, or the rim of the image, may do so for some time.
  bool may_be_a_mark(const CellTrack& track) const;
  /// Whether the track may be a target: it is new, or it surely moves.
  bool may_be_target(const CellTrack& track) const;
  /// Prior odds that what begins at a peak moves.
  double first_odds(const ScaleSpace& scales, const CellGeometry& geometry, const Candidate& peak) const;
  /// Keeps a place where something stands.
  void remember(const Eigen::Vector2d& position, double time);
  void forget_old(double time);  ///< Places older than the memory.
  void reset();                  ///< Forgets all places; what is seen next is new.

 private:
  struct Place {
    Eigen::Vector2d position;
    double time;
  };
  bool is_new(const CellTrack& track) const;
  double moved_ratio(const CellTrack& track, const Eigen::Matrix2d& place, const Eigen::Vector2d& along,
                     double passed) const;
  double way_ratio(const Eigen::Vector2d& way, const Eigen::Matrix2d& standing) const;
  double motion_ratio(const Eigen::Vector2d& v, const Eigen::Matrix2d& standing) const;
  bool known_at(const ScaleSpace& scales, const CellGeometry& geometry, const Candidate& candidate) const;

  CellStandingParams params_;
  std::vector<Place> places_;
  double time_ = 0.0;         ///< Of the frame at hand [s].
  double learnt_time_ = 0.0;  ///< Tracks before it began while the background was unknown [s].
  int frames_ = 0;
};

}  // namespace lookout::tracking
