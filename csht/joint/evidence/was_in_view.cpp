#include "csht/joint/evidence/was_in_view.hpp"

#include <cmath>

namespace lookout::csht {

bool was_in_view(const CloudMoments& moments, const ScanHistory& scans, int oldest) {
  for (int age = 0; age <= oldest; ++age) {
    const ScanTable& scan = scans.at_age(age);
    const Eigen::Vector2d at = state_at(moments.motion, moments.mean, scans.seconds_at_age(age)).head<2>() -
                               Eigen::Vector2d(scan.T_earth_sonar.north, scan.T_earth_sonar.east);
    const double from_axis = std::abs(core::wrap_to_pi(std::atan2(at.y(), at.x()) - scan.axis));
    if (at.norm() <= kBeyondEdge * scan.max_range &&
        from_axis <= kBeyondEdge * static_cast<double>(scan.half_sector))
      return true;
  }
  return false;
}

}  // namespace lookout::csht
