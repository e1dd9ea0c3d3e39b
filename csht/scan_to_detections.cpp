#include "csht/scan_to_detections.hpp"

#include <cmath>

#include "core/uneven_fan.hpp"

namespace lookout::csht {

namespace {

/// Number of the beam whose centre is nearest; of bearings beyond the fan that of a beam that is not there.
int nearest_beam(const core::SonarScan& scan, double bearing) {
  if (scan.fan) return static_cast<int>(std::floor(scan.fan->place_of(bearing) + 0.5));
  return static_cast<int>(std::lround((bearing - scan.first_bearing) / scan.bearing_step));
}

}  // namespace

int scan_to_detections(const core::PosedScan& posed, int scan_index,
                       std::vector<core::Detection>& detections) {
  const core::SonarScan& scan = posed.scan;
  const Eigen::Vector2d p_earth_sonar(posed.T_earth_sonar.north, posed.T_earth_sonar.east);
  detections.clear();
  for (const auto& sonar_return : scan.returns) {
    if (!std::isfinite(sonar_return.bearing) ||
        !(sonar_return.range > 0.0 && sonar_return.range <= scan.max_range))
      continue;
    core::Detection detection;
    detection.utime = scan.utime;
    detection.scan = scan_index;
    detection.beam = nearest_beam(scan, sonar_return.bearing);
    detection.range = sonar_return.range;
    detection.bearing = sonar_return.bearing;
    detection.intensity = sonar_return.intensity;
    detection.azimuth = core::wrap_to_pi(posed.T_earth_sonar.heading + sonar_return.bearing);
    detection.p_earth =
        core::transform(posed.T_earth_sonar, core::from_polar(sonar_return.range, sonar_return.bearing));
    detection.p_earth_sonar = p_earth_sonar;
    detections.push_back(detection);
  }
  return static_cast<int>(scan.returns.size() - detections.size());
}

}  // namespace lookout::csht
