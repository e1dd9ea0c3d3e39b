#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion_element.hpp"
#include "tracking/intake/scan_intake.hpp"
#include "tracking/ping_result.hpp"
#include "tracking/track_before_detect/images/image_tracker.hpp"

namespace lookout::tracking {

/// Intake and image tracker in one: vehicle states and images in as they arrive, tracks out image by image.
class ImageChain {
 public:
  using Ping = core::SonarImage;
  using OnResult = std::function<void(const PingResult&)>;  ///< Once for each accepted image, in their order.
  using Report = std::function<void(const std::string&)>;   ///< One line for a person.

  /// @param method that of an ImageTracker. The fastest target is that of `configured`.
  ImageChain(const core::SonarParams& configured, std::string_view method, OnResult on_result, Report report,
             const InstrumentParams& instrument = {}, const IntakeParams& params = {});
  ImageChain(const ImageChain&) = delete;
  ImageChain& operator=(const ImageChain&) = delete;

  /// Takes a vehicle state; tracks the images that waited for it.
  void add(const core::VehicleState& state) { intake_.add(state); }
  /// Takes an image; tracked at once where its pose is known.
  void add(core::SonarImage image) { intake_.add(std::move(image)); }
  /// An image came for which there is no time: it is counted and left out.
  void shed(const core::SonarImage& image) { intake_.shed(image); }
  void finish() { intake_.finish(); }  ///< There is no more data.
  /// What comes now is on another clock, as who keeps a recording knows.
  void start_new_clock() { intake_.start_new_clock(); }

  const IntakeCounts& counts() const { return intake_.counts(); }  ///< Of the intake, since the start.
  /// Of the data that was believed [us]; 0 before any.
  std::int64_t newest_utime() const { return intake_.newest_utime(); }

 private:
  void track(const core::PosedImage& posed);

  ImageTracker tracker_;
  OnResult on_result_;
  std::vector<core::MotionElement> elements_;
  ImageIntake intake_;
};

/// Tracks as motion elements of their own: what track-before-detect has in place of a window's estimates.
/// @param utime of the image that the tracks are of [us].
std::vector<core::MotionElement> as_elements(std::span<const core::Track> tracks, std::int64_t utime);

}  // namespace lookout::tracking
