#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "core/sonar_scan.hpp"
#include "core/uneven_fan.hpp"

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

/// As many beams over the same sector, even in the sine of the bearing: .9
/// degrees wide in the middle, 1.3 at the edges.
inline std::shared_ptr<const core::UnevenFan> sine_fan() {
  std::vector<double> centres;
  centres.reserve(90);
  const double outer = std::sin(core::radians(44.5));
  for (int beam = 0; beam < 90; ++beam) centres.push_back(std::asin(outer * (2.0 * beam / 89.0 - 1.0)));
  return std::make_shared<const core::UnevenFan>(std::move(centres));
}

/// A scan of those beams, each return at the centre of its beam.
inline core::PosedScan uneven_scan(std::vector<core::SonarReturn> returns) {
  core::PosedScan posed = posed_scan(std::move(returns));
  posed.scan.fan = sine_fan();
  for (auto& one : posed.scan.returns)
    one.bearing = posed.scan.fan->centre(posed.scan.fan->beam_of(one.bearing));
  return posed;
}

}  // namespace lookout::csht
