#include "csht/likelihood/sensor_units.hpp"

#include <algorithm>

namespace lookout::csht {
namespace {

constexpr double kShortestTime = 1e-3, kLongestTime = 1e3;  // [s]

}  // namespace

double unit_of_time(const core::SonarParams& sonar) {
  return std::clamp(sonar.range_sigma / sonar.max_speed, kShortestTime, kLongestTime);
}

double sensor_seconds(double units, double least_scans, const core::SonarParams& sonar) {
  return std::max(units * unit_of_time(sonar), least_scans * sonar.scan_period);
}

}  // namespace lookout::csht
