#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/sonar_image.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "tracking/detection/detection_params.hpp"
#include "tracking/detection/detection_window.hpp"
#include "tracking/detection/echo_filter.hpp"
#include "tracking/detection/gain_background.hpp"
#include "tracking/detection/image_geometry.hpp"
#include "tracking/detection/image_plane.hpp"
#include "tracking/detection/peak_law.hpp"
#include "tracking/detection/reference_level.hpp"
#include "tracking/detection/speckle_grain.hpp"

namespace lookout::tracking {

/// What a detector did so far.
struct DetectionCounts {
  std::int64_t images = 0;    ///< That were looked at.
  std::int64_t returns = 0;   ///< That were given.
  std::int64_t left_out = 0;  ///< Beyond the most that a ping may have.
};

/// The front door of detection: one sonar's images to returns, one for each echo. What it learns it learns
/// from the images alone, ping by ping; a new geometry begins anew.
class ImageDetector {
 public:
  /// @throws std::invalid_argument naming the parameter out of range.
  explicit ImageDetector(const DetectionParams& params = {});

  /// The returns of an image, strongest first, with intensity in dB over the background; time, sequence,
  /// sensor and mount are the image's. Valid until the next call. The image is to be without defect
  /// (tracking/intake/ping_checks). Allocates nothing once warm. Work: some 60 operations a cell.
  const core::SonarScan& detect(const core::SonarImage& image);

  /// What a tracker should know of the returns: `params` with the stated false-alarm rate as clutter a scan,
  /// and the errors of range and bearing that the extent of an echo leads to; the geometry is the last
  /// image's. P_M depends on the targets and stays as it is.
  core::SonarParams sensor_figures(const core::SonarParams& params) const;

  const ImageGeometry& geometry() const { return geometry_; }  ///< Of the last image.
  const EchoExtent& extent() const { return extent_; }         ///< Of an echo in the last image.
  const DetectionCounts& counts() const { return counts_; }    ///< Since the start.
  const DetectionParams& params() const { return params_; }    ///< As given.
  /// Of each zone of range in the last image: ratio to the background above which a peak is a return.
  const std::vector<double>& thresholds() const { return thresholds_; }

 private:
  void begin_ping(const core::SonarImage& image);
  void begin_geometry();
  void measure_extent(const ImagePlane& plane);
  void use(const EchoExtent& extent);
  void compare_with_reference(const ImagePlane& plane);
  void keep_above_threshold();
  void keep_strongest();
  void give_returns(const ImagePlane& plane);
  std::size_t zone_of(int bin) const;

  DetectionParams params_;
  ImageGeometry geometry_, next_geometry_;
  int pings_ = 0;  ///< In this geometry.
  GainBackground background_;
  SpeckleGrain grain_;
  EchoExtent extent_;
  DetectionWindow window_;
  EchoFilter filter_;
  std::vector<PlanePeak> peaks_;
  std::unique_ptr<ReferenceLevel> reference_;
  std::vector<PeakLaw> laws_;       ///< By zone.
  std::vector<double> thresholds_;  ///< Likewise.
  core::SonarScan scan_;
  DetectionCounts counts_;
};

}  // namespace lookout::tracking
