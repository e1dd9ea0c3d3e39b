#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// One target as a frame tracker sees it, in pixels. State order x, y [px], x and y velocity [px per unit of
/// time]; pixel centres at .5.
struct FrameTrack {
  std::int64_t id = 0;                ///< As it was added.
  Eigen::Vector4d state{0, 0, 0, 0};  ///< x, y [px], x and y velocity [px per unit of time].
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< Of `state`.
  double intensity = 0.0;  ///< Intensity above the threshold that belongs to the target.
  double existence = 1.0;  ///< Probability that there is a target; 1 where nothing judges it.
  bool lost = false;       ///< Left the frame: the state is dead-reckoned.
};

/// A tracker of known targets in a sequence of frames of one size.
class FrameTracker {
 public:
  virtual ~FrameTracker() = default;

  /// How many frames `process` takes at once at most.
  virtual int batch_length() const = 0;

  /// Adds a target known at the time of the last frame processed (before the first: of the start).
  virtual void add(std::int64_t id, const Eigen::Vector4d& state, const Eigen::Matrix4d& covariance) = 0;
  virtual void remove(std::int64_t id) = 0;  ///< Forgets a target; one that is unknown changes nothing.

  /// Takes up to batch_length() frames; steps[t] >= 0 is the time from the frame before (at
  /// first: from the start) to frames[t].
  /// @return the targets at each of the frames; valid until the next call.
  /// @throws std::invalid_argument where a frame is damaged (see check_frame) or changes its size. The gated
  /// form finds a damaged cell only where it looks, and may have begun to move its targets by then.
  virtual const std::vector<std::vector<FrameTrack>>& process(std::span<const IntensityFrame> frames,
                                                              std::span<const double> steps) = 0;
};

}  // namespace lookout::tracking
