#pragma once

#include <span>
#include <vector>

#include "core/detection.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "tracking/initiation/plots/plot_window.hpp"

namespace lookout::tracking {

/// The detections of a sonar as the plots that an initiator takes: positions relative to the sonar's place at
/// its first scan, the noise of each, and the density of clutter, which falls with range, since clutter is
/// even over range and bearing.
class SonarPlots {
 public:
  /// The plots of one scan, whose geometry wins over that of `sonar`; valid until the next call.
  std::span<const Plot> of(const core::PosedScan& scan, const core::SonarParams& sonar);

  const Eigen::Vector2d& p_earth_origin() const { return p_earth_origin_; }  ///< Of the plots [m].

 private:
  bool has_origin_ = false;
  Eigen::Vector2d p_earth_origin_{0, 0};
  double returns_per_scan_ = 0.0;  ///< Slow mean.
  std::vector<core::Detection> detections_;
  std::vector<Plot> plots_;
};

}  // namespace lookout::tracking
