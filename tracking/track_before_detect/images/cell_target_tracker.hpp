#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tracking/track_before_detect/images/cell_geometry.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// One target tracked in image cells; state order as core::Track.
struct CellTrack {
  std::int64_t id = 0;                ///< Unique within a run, never used again.
  Eigen::Vector4d state{0, 0, 0, 0};  ///< Position, velocity; of a sonar image north, east [m, m/s].
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< Of `state`.
  double existence = 0.0;                                ///< Probability that there is a target.
  double intensity = 0.0;                                ///< Smoothed lambda [background level].
  bool measured = false;             ///< Whether the last frame held intensity of its signature.
  bool confirmed = false;            ///< Once true, it stays so.
  bool inside = true;                ///< In the image at the last frame.
  int age = 0;                       ///< Frames since its first.
  double first_time = 0.0;           ///< [s]
  double last_detection_time = 0.0;  ///< When its block last ranked in the best twentieth [s].
  double outside_since = 0.0;        ///< [s], while not inside.
};

/// A tracker of an unknown number of targets in frames whose background is about 1, wherever its cells lie.
class CellTargetTracker {
 public:
  virtual ~CellTargetTracker() = default;

  /// Takes the frame at `time` [s]; times increase. The tracks stay valid until the next call.
  virtual const std::vector<CellTrack>& update(const IntensityFrame& frame, const CellGeometry& geometry,
                                               double time) = 0;
  virtual void reset() = 0;  ///< Forgets all tracks; ids go on.
};

}  // namespace lookout::tracking
