#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "csht/likelihood/scan_history.hpp"

namespace lookout {

/// Scan `index` (every half second) of the default sonar at the origin, heading north, with exact returns of
/// these earth-frame points.
inline core::PosedScan scan_of(int index, const std::vector<Eigen::Vector2d>& points) {
  const core::SonarParams sonar;
  core::PosedScan posed;
  posed.scan.utime = 500'000 * static_cast<std::int64_t>(index);
  posed.scan.sequence = index;
  posed.scan.num_beams = sonar.num_beams;
  posed.scan.first_bearing = sonar.first_bearing;
  posed.scan.bearing_step = sonar.bearing_step;
  posed.scan.max_range = sonar.max_range;
  for (const auto& point : points)
    posed.scan.returns.push_back({std::atan2(point.y(), point.x()), point.norm()});
  return posed;
}

/// One silent scan of a sonar with these figures.
inline csht::ScanHistory one_scan(double miss, double false_alarm) {
  csht::SensorFigures figures;
  figures.miss_probability = miss;
  figures.false_alarm_probability = false_alarm;
  csht::ScanHistory scans(figures, {}, 4);
  scans.push(scan_of(0, {}));
  return scans;
}

}  // namespace lookout
