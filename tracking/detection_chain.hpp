#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "core/sonar_image.hpp"
#include "tracking/detection/image_detector.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tracking {

/// Which of the sensor's figures a user has given; the others are the detector's (docs/detect.md).
struct GivenFigures {
  bool clutter = false;        ///< `clutter_per_scan` or `false_alarm_probability`.
  bool range_sigma = false;    ///< Of a range.
  bool bearing_sigma = false;  ///< Of a bearing.
  bool resolution = false;     ///< At which two targets give one return.
};

/// The given params with those figures of the detector's that were not given.
core::SonarParams with_figures(const core::SonarParams& given, const GivenFigures& which,
                               const ImageDetector& detector);

/// Detectors of images, one for each sonar of the stream, and what became of the images.
class StreamDetector {
 public:
  using Report = std::function<void(const std::string&)>;  ///< One line for a person.

  static constexpr std::size_t kMostSonars = 64;  ///< Of one vehicle; the images of more are rejected.

  /// @throws std::invalid_argument naming the parameter out of range.
  StreamDetector(const DetectionParams& params, Report report);

  /// The returns of an image, valid until the next call; null, counted and reported, of one with a defect.
  const core::SonarScan* detect(const core::SonarImage& image);

  /// Of the sonar of the last image. Asks that there was one.
  const ImageDetector& detector() const { return *latest_; }
  std::int64_t damaged() const { return damaged_; }  ///< Images that were rejected.
  DetectionCounts counts() const;                    ///< Of all sonars.

 private:
  DetectionParams params_;
  Report report_;
  std::map<std::int32_t, ImageDetector> detectors_;
  ImageDetector* latest_ = nullptr;
  std::int64_t damaged_ = 0;
};

/// A tracking chain on images: vehicle states and images in as they arrive, tracks out. Each image becomes a
/// scan, and from there on all is as with scans, so that tracks are the same whether the returns were made
/// here, in `lookout detect` before it, or read from a recording of those.
class DetectionChain {
 public:
  using Ping = core::SonarImage;
  using OnResult = TrackingChain::OnResult;                         ///< Once for each accepted image.
  using Report = TrackingChain::Report;                             ///< One line for a person.
  using OnScan = std::function<void(const core::SonarScan& scan)>;  ///< Each scan that was made.

  /// @param which of `params.sensor` were given: the first image's detector tells the rest.
  /// @param on_scan may be empty. @throws std::invalid_argument on params out of range.
  DetectionChain(const DetectionParams& detection, const ChainParams& params, const GivenFigures& which,
                 OnResult on_result, Report report, OnScan on_scan = {});
  DetectionChain(const DetectionChain&) = delete;
  DetectionChain& operator=(const DetectionChain&) = delete;

  void add(const core::VehicleState& state);  ///< Takes a vehicle state.
  void add(const core::SonarImage& image);    ///< Takes an image. A bad one is counted and left out.
  /// An image came for which there is no time: it is counted and left out.
  void shed(const core::SonarImage& image);
  void stop_when(std::function<bool()> stopped) { chain_.stop_when(std::move(stopped)); }  ///< See there.
  void finish();           ///< There is no more data: gives what still waits.
  void start_new_clock();  ///< What comes now is on another clock.

  const IntakeCounts& counts() const { return counts_; }  ///< Of the images, damaged ones among them.
  DetectionCounts detections() const { return detector_.counts(); }  ///< Of the returns.
  /// Newest time among all data so far [us].
  std::int64_t newest_utime() const { return chain_.newest_utime(); }
  const core::SonarParams& sensor() const { return sensor_; }  ///< With the detector's figures once known.

 private:
  void count();

  core::SonarParams sensor_;
  GivenFigures which_;
  OnScan on_scan_;
  StreamDetector detector_;
  TrackingChain chain_;
  bool is_first_ = true;
  IntakeCounts counts_;
};

}  // namespace lookout::tracking
