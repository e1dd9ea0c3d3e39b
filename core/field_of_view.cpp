#include "core/field_of_view.hpp"

#include <cmath>

namespace lookout::core {

SonarParams with_geometry_of(const SonarScan& scan, const SonarParams& params) {
  SonarParams result = params;
  result.num_beams = scan.num_beams;
  // A message rounds the mean of uneven beams as its sender does; the table has one.
  result.first_bearing = scan.fan ? scan.fan->centre(0) : scan.first_bearing;
  result.bearing_step = scan.fan ? scan.fan->mean_step() : scan.bearing_step;
  result.fan = scan.fan;
  result.max_range = scan.max_range;
  result.T_body_sonar = scan.T_body_sonar;
  return result;
}

SonarPoint observe(const SonarParams& params, const Pose2& T_earth_sonar, const Eigen::Vector2d& p_earth) {
  const Eigen::Vector2d p_sonar = inverse_transform(T_earth_sonar, p_earth);
  SonarPoint point;
  point.range = p_sonar.norm();
  point.bearing = std::atan2(p_sonar.y(), p_sonar.x());
  point.beam = params.beam_of(point.bearing);
  point.in_range = point.range > 0.0 && point.range <= params.max_range;
  return point;
}

}  // namespace lookout::core
