#include "tracking/intake/ping_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
/// Geometry that differs by less is the same [m, rad]: a configuration in degrees does not round to the bit.
constexpr double kSameGeometry = 1e-9;

// Each comparison is false for NaN, so that these also say "finite".
bool within(double value, double limit) {
  return std::abs(value) <= limit;
}

bool positive_below(double value, double limit) {
  return value > 0.0 && value <= limit;
}

bool valid_time(std::int64_t utime) {
  return utime >= -core::kMaxUtime && utime <= core::kMaxUtime;
}

template <class Ping>
std::string_view header_defect(const Ping& ping) {
  const core::Pose2& mount = ping.T_body_sonar;
  if (!valid_time(ping.utime)) return "time out of range";
  if (!within(mount.north, PingLimits::kMaxMount) || !within(mount.east, PingLimits::kMaxMount) ||
      !within(mount.heading, PingLimits::kMaxAngle))
    return "mount out of range";
  if (ping.num_beams < 1 || ping.num_beams > PingLimits::kMaxBeams) return "number of beams out of range";
  if (!within(ping.first_bearing, kFullTurn) || !positive_below(ping.bearing_step, kFullTurn) ||
      ping.num_beams * ping.bearing_step > kFullTurn * (1.0 + kSameGeometry))
    return "bearings out of range";
  return {};
}

template <class Ping>
bool same_sector(const Ping& ping, const core::SonarParams& configured) {
  const auto same = [](double a, double b) { return within(a - b, kSameGeometry); };
  return ping.num_beams == configured.num_beams && same(ping.first_bearing, configured.first_bearing) &&
         same(ping.bearing_step, configured.bearing_step) &&
         same(ping.T_body_sonar.north, configured.T_body_sonar.north) &&
         same(ping.T_body_sonar.east, configured.T_body_sonar.east) &&
         same(ping.T_body_sonar.heading, configured.T_body_sonar.heading);
}

}  // namespace

std::string_view defect(const core::SonarScan& scan) {
  if (const auto header = header_defect(scan); !header.empty()) return header;
  if (!positive_below(scan.max_range, PingLimits::kMaxRange)) return "maximum range out of range";
  const auto finite = [](const core::SonarReturn& echo) {
    return std::isfinite(echo.bearing) && std::isfinite(echo.range) && std::isfinite(echo.intensity);
  };
  if (!std::all_of(scan.returns.begin(), scan.returns.end(), finite)) return "a return is not finite";
  return {};
}

std::string_view defect(const core::SonarImage& image) {
  if (const auto header = header_defect(image); !header.empty()) return header;
  if (!within(image.first_range, PingLimits::kMaxRange) ||
      !positive_below(image.range_step, PingLimits::kMaxRange) || image.num_bins < 1)
    return "ranges out of range";
  const std::size_t pixels =
      static_cast<std::size_t>(image.num_beams) * static_cast<std::size_t>(image.num_bins);
  if (pixels > PingLimits::kMaxPixels || pixels != image.intensity.size()) return "sizes disagree";
  if (!std::all_of(image.intensity.begin(), image.intensity.end(), [](double v) { return std::isfinite(v); }))
    return "an intensity is not finite";
  return {};
}

std::string_view defect(const core::VehicleState& state) {
  if (!valid_time(state.utime)) return "time out of range";
  const core::Pose2& pose = state.T_earth_body;
  if (!within(pose.north, PingLimits::kMaxPosition) || !within(pose.east, PingLimits::kMaxPosition) ||
      !within(pose.heading, PingLimits::kMaxAngle))
    return "pose out of range";
  if (!within(state.velocity.x(), PingLimits::kMaxSpeed) ||
      !within(state.velocity.y(), PingLimits::kMaxSpeed))
    return "velocity out of range";
  return {};
}

int drop_out_of_bounds(core::SonarScan& scan) {
  const double middle = scan.first_bearing + 0.5 * (scan.num_beams - 1) * scan.bearing_step;
  const auto is_outside = [&scan, middle](core::SonarReturn& echo) {
    if (!positive_below(echo.range, scan.max_range) || !within(echo.bearing, PingLimits::kMaxAngle))
      return true;
    const double offset = echo.bearing - middle;
    // Left as it came where it is near already: the same bits in every way that a scan can take.
    if (!within(offset, std::numbers::pi)) echo.bearing = middle + std::remainder(offset, kFullTurn);
    const long beam = std::lround((echo.bearing - scan.first_bearing) / scan.bearing_step);
    return beam < 0 || beam >= scan.num_beams;
  };
  const auto first_gone = std::remove_if(scan.returns.begin(), scan.returns.end(), is_outside);
  const auto gone = scan.returns.end() - first_gone;
  scan.returns.erase(first_gone, scan.returns.end());
  return static_cast<int>(gone);
}

int drop_out_of_bounds(core::SonarImage& /*image*/) {
  return 0;
}

bool agrees(const core::SonarScan& scan, const core::SonarParams& configured) {
  return same_sector(scan, configured) && within(scan.max_range - configured.max_range, kSameGeometry);
}

bool agrees(const core::SonarImage& image, const core::SonarParams& configured) {
  return same_sector(image, configured);
}

}  // namespace lookout::tracking
