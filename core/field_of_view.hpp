#pragma once

#include <Eigen/Core>

#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"

namespace lookout::core {

/// A point as the sonar sees it.
struct SonarPoint {
  double range = 0.0;     ///< [m].
  double bearing = 0.0;   ///< [rad], positive to starboard of the sonar axis, in (-pi, pi].
  int beam = -1;          ///< The beam it lies in, -1 outside the sector.
  bool in_range = false;  ///< Range in (0, max_range].
  bool visible() const { return beam >= 0 && in_range; }  ///< Inside the sector and the range.
};

/// The geometry of a scan (it wins over configuration) as sonar params; accuracy and probabilities from
/// `params`.
SonarParams with_geometry_of(const SonarScan& scan, const SonarParams& params);

/// Where the sonar sees the earth-frame point p_earth [m].
SonarPoint observe(const SonarParams& params, const Pose2& T_earth_sonar, const Eigen::Vector2d& p_earth);

}  // namespace lookout::core
