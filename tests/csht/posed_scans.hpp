#pragma once

#include <vector>

#include "core/sonar_scan.hpp"

namespace lookout::csht {

/// A scan of the sonar of [Yan2018] Table 1 with these returns.
inline core::PosedScan posed_scan(std::vector<core::SonarReturn> returns, std::int64_t utime = 0,
                                  const core::Pose2& T_earth_sonar = {}) {
  core::PosedScan posed;
  posed.scan.utime = utime;
  posed.scan.first_bearing = core::radians(-44.5);
  posed.scan.bearing_step = core::radians(1.0);
  posed.scan.num_beams = 90;
  posed.scan.max_range = 150.0;
  posed.scan.returns = std::move(returns);
  posed.T_earth_sonar = T_earth_sonar;
  return posed;
}

}  // namespace lookout::csht
