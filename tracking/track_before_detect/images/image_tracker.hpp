#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/sonar_image.hpp"
#include "core/track.hpp"
#include "tracking/track_before_detect/images/cell_tracker.hpp"
#include "tracking/track_before_detect/images/image_background.hpp"
#include "tracking/track_before_detect/images/peak_tracker.hpp"

namespace lookout::tracking {

/// What the tracker did with the images it was given.
struct ImageCounts {
  std::int64_t accepted = 0;      ///< Images that were tracked.
  std::int64_t damaged = 0;       ///< Wrong size, a value not finite or negative, or a geometry that is none.
  std::int64_t out_of_order = 0;  ///< Not later than the image before.
};

/// What is known of the instrument and its targets beside the image's own geometry.
struct InstrumentParams {
  double pulse_length =
      0.0;  ///< Full width of an echo at half its amplitude [m], >= 0; 0: found in the images.
  double beam_width = 0.0;  ///< The same across beams [rad], >= 0; 0: found in the images.
  double max_speed = 3.0;   ///< Fastest target over ground [m/s], > 0.
  double slowest = 0.0;     ///< Target that is no background [m/s], >= 0; 0: a tenth of the fastest.
  double birth_rate = 6.0;  ///< Targets expected to appear in a second, three a ping at most [1/s], > 0.
  double mark_time = 5.0;   ///< For which a mark of the instrument may go along with the sonar [s], >= 0.
};

/// The cell tracker's parameters for an instrument. @throws std::invalid_argument for a value out of range.
CellTrackerParams sonar_tracker_params(const InstrumentParams& instrument);

/// The same of the background's parameters.
ImageBackgroundParams sonar_background_params(const InstrumentParams& instrument);

/// The front door of track-before-detect on sonar images: image by image to tracks in the earth frame.
class ImageTracker {
 public:
  /// @param method "h_pmht", or a baseline, "mf_nn" or "cfar_nn". @throws std::invalid_argument for any
  /// other.
  explicit ImageTracker(std::string_view method = "h_pmht", const InstrumentParams& instrument = {});
  /// With parameters of one's own.
  ImageTracker(std::unique_ptr<CellTargetTracker> targets, const ImageBackgroundParams& background);

  /// Takes one image; valid until the next call. A damaged image or one out of order is counted and leaves
  /// the tracks as they were.
  std::span<const core::Track> update(const core::PosedImage& posed);

  /// As after the newest image; valid until the next.
  std::span<const core::Track> tracks() const { return tracks_; }
  const ImageCounts& counts() const { return counts_; }  ///< Since the start.
  /// By which the newest image was divided.
  const ImageBackground& background() const { return background_; }
  void reset();  ///< Forgets tracks and time, for a new clock; ids and counts go on.

 private:
  bool accept(const core::PosedImage& posed);
  void publish(const std::vector<CellTrack>& tracks);

  ImageBackground background_;
  std::unique_ptr<CellTargetTracker> targets_;
  std::vector<core::Track> tracks_;
  ImageCounts counts_;
  bool started_ = false;
  std::int64_t last_utime_ = 0;
};

/// Why an image cannot be used, or an empty text.
std::string image_fault(const core::PosedImage& posed);

}  // namespace lookout::tracking
