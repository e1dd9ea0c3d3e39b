#include "tracking/intake/intake_words.hpp"

#include "core/files/time_text.hpp"

namespace lookout::tracking {
namespace {

std::string described(const std::string& kind, std::int32_t sensor_id, std::int64_t utime) {
  const std::string sensor = sensor_id == 0 ? "" : " of sensor " + std::to_string(sensor_id);
  return kind + sensor + at_time(utime);
}

}  // namespace

bool worth_a_line(std::int64_t n) {
  return (n & (n - 1)) == 0;
}

std::string at_time(std::int64_t utime) {
  return " at " + core::time_text(utime) + " s";
}

std::string so_far(std::int64_t count) {
  return " (" + std::to_string(count) + " so far)";
}

std::string described(const core::SonarScan& scan) {
  return described("scan", scan.sensor_id, scan.utime);
}

std::string described(const core::SonarImage& image) {
  return described("image", image.sensor_id, image.utime);
}

}  // namespace lookout::tracking
