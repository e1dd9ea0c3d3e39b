#pragma once

#include <vector>

#include "core/sonar_image.hpp"
#include "tracking/track_before_detect/intensity_frame.hpp"

namespace lookout::tracking {

/// Parameters of the level that a sonar image is divided by.
struct RangeBackgroundParams {
  int half_window = 7;  ///< Bins on either side of the running median, >= 0.
};

/// Divides a sonar image by its level at each range: the median over all beams, smoothed by a running median
/// over range. What is left has a background of about 1 whatever the range-dependent level.
class RangeBackground {
 public:
  /// @throws std::invalid_argument for a negative window.
  explicit RangeBackground(const RangeBackgroundParams& params = {});

  /// The normalised image, columns being bins and rows beams; valid until the next call. Bins without any
  /// level are dark. The image is to be finite, not negative and of the size it states.
  const IntensityFrame& normalise(const core::SonarImage& image);

  const std::vector<double>& level() const { return level_; }  ///< By bin.

 private:
  RangeBackgroundParams params_;
  std::vector<double> median_, level_, scratch_;
  IntensityFrame frame_;
};

}  // namespace lookout::tracking
