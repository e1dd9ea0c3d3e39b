#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tracking/track_before_detect/frames/frame_tracker_registry.hpp"
#include "tracking/track_before_detect/frames/spot_tracker.hpp"
#include "tracking/track_before_detect/images/cell_tracker.hpp"

namespace lookout::tracking {

/// Tracks of a sequence of frames by one method of the registry: from a given start, or with targets that are
/// found, confirmed and ended by the rank of their blocks (CellTracker) and estimated by the method.
class SequenceTracker {
 public:
  /// @throws std::invalid_argument for an unknown method or parameters out of range.
  SequenceTracker(std::string_view method, const TbdParams& params);

  /// Frames that `process` takes at once at most.
  int batch_length() const { return method_->batch_length(); }

  /// Takes up to batch_length() frames; steps[t] is the time from the frame before [frames], >= 0.
  /// @param greys grey levels of the same frames: targets without a start are then found as spots of local
  /// contrast and motion, and where the method departs from its spot the spot counts. Empty: they are found
  /// in the intensities.
  /// @return the targets at each of the frames, those that are lost left out; valid until the next call.
  const std::vector<std::vector<FrameTrack>>& process(std::span<const IntensityFrame> frames,
                                                      std::span<const double> steps,
                                                      std::span<const std::vector<double>> greys = {});

 private:
  /// Existence at each frame of the batch, and which targets the method is to follow from the next one on.
  void judge(std::span<const IntensityFrame> frames, std::span<const double> steps);
  void judge_spots(std::span<const IntensityFrame> frames, std::span<const double> steps,
                   std::span<const std::vector<double>> greys);
  void hold_to_spots();
  void follow_confirmed();
  double existence(std::size_t frame, std::int64_t id) const;

  TbdParams params_;
  std::unique_ptr<FrameTracker> method_;
  CellTracker judge_;
  SpotTracker spots_;
  std::vector<std::vector<CellTrack>> judged_;  ///< By frame of the batch.
  std::vector<std::int64_t> followed_;          ///< Ids that the method tracks.
  IntensityFrame scaled_;
  double time_ = 0.0;
  std::vector<std::vector<FrameTrack>> tracks_;
};

/// The cell tracker's parameters for targets of an area in frames of pixels.
CellTrackerParams pixel_tracker_params(const TbdParams& params);

}  // namespace lookout::tracking
