#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tracking/track_before_detect/images/cell_geometry.hpp"
#include "tracking/track_before_detect/images/course_mixture.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// One target tracked in image cells; state order as core::Track.
struct CellTrack {
  std::int64_t id = 0;                ///< Unique within a run, never used again.
  Eigen::Vector4d state{0, 0, 0, 0};  ///< Position, velocity; of a sonar image north, east [m, m/s].
  /// Of `state` for a target that turns as much as the filter allows for: what gates and gains follow.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  /// Of the error of `state` for a target that turns as targets mostly do, under the same gains: what
  /// innovations are held against, and published until the course is known.
  Eigen::Matrix4d error = Eigen::Matrix4d::Zero();
  double existence = 0.0;        ///< Probability that there is a target.
  double intensity = 0.0;        ///< Smoothed lambda [background level].
  bool measured = false;         ///< Whether the last frame held intensity of its signature.
  bool confirmed = false;        ///< Once true, it stays so.
  double moving = 1.0;           ///< Probability that it moves over ground.
  double moving_in_frame = 1.0;  ///< The same in the sensor's frame.
  double unrest = 1.0;       ///< Squared innovations over what is expected, smoothed; 1 on a steady course.
  double moving_odds = 5.0;  ///< Prior odds that it moves.
  double least_existence = 0.0;          ///< Below it a tentative track is given up.
  int scale = 0;                         ///< Of the cells in which it is measured.
  Eigen::Vector2d signature{0, 0};       ///< Standard deviation of its intensity [m, rad; px].
  bool inside = true;                    ///< In the image at the last frame.
  bool whole = true;                     ///< And all of its signature.
  int age = 0;                           ///< Frames since its first.
  Eigen::Vector2d first_position{0, 0};  ///< Where it began, or was first seen whole.
  Eigen::Vector2d first_cell{0, 0};      ///< And at which cell of the image.
  double first_time = 0.0;               ///< When it began [s].
  double whole_time = 0.0;               ///< And since when its way is judged [s].
  double last_detection_time = 0.0;      ///< When its block last ranked in the best twentieth [s].
  double outside_since = 0.0;            ///< [s], while not inside.

  CourseMixture course;  ///< Of what is believed to be a target: published, `systematic` added.

  static constexpr double kRestless = 2.2;        ///< Unrest at which it begins to count as agile.
  static constexpr std::size_t kMostScales = 64;  ///< That a frame is looked at in.
  Eigen::Matrix2d systematic =
      Eigen::Matrix2d::Zero();  ///< Error of the position that repeats, beside `error`.
  /// ln of the probability of its block without a target, by scale, smoothed.
  std::array<float, kMostScales> scale_score{};
};

/// What a tracker claims of the frame it last took, for the background to learn by.
struct CellClaims {
  std::vector<CellWindow> targets;   ///< Cells that may hold a target: no background.
  std::vector<CellWindow> standing;  ///< Cells of what was found to stand: background from now on.
};

/// A tracker of an unknown number of targets in frames whose background is about 1, wherever its cells lie.
class CellTargetTracker {
 public:
  virtual ~CellTargetTracker() = default;

  /// Takes the frame at `time` [s]; times increase. The tracks stay valid until the next call.
  virtual const std::vector<CellTrack>& update(const IntensityFrame& frame, const CellGeometry& geometry,
                                               double time) = 0;
  /// Of the last frame; valid until the next. None of a tracker that leaves the cells to no memory.
  virtual const CellClaims* claims() const { return nullptr; }
  virtual void reset() = 0;  ///< Forgets all tracks; ids go on.
};

}  // namespace lookout::tracking
