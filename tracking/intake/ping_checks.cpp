#include "tracking/intake/ping_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/beam_bearings.hpp"
#include "core/uneven_fan.hpp"

namespace lookout::tracking {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
/// Geometry that differs by less is the same [m, rad]: a configuration in degrees does not round to the bit.
constexpr double kSameGeometry = 1e-9;

/// Fewer returns at one range are chance,
constexpr std::size_t kFewestReturns = 8;
constexpr std::ptrdiff_t kFewestAtMaximum = 3;  // and fewer at the maximum.

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

/// What is wrong with time, mount or beams of a ping.
template <class Ping>
std::string_view header_defect(const Ping& ping, int num_beams) {
  const core::Pose2& mount = ping.T_body_sonar;
  if (!valid_time(ping.utime)) return "time out of range";
  if (!within(mount.north, PingLimits::kMaxMount) || !within(mount.east, PingLimits::kMaxMount) ||
      !within(mount.heading, PingLimits::kMaxAngle))
    return "mount out of range";
  if (num_beams < 1 || num_beams > PingLimits::kMaxBeams) return "number of beams out of range";
  return {};
}

bool same(double a, double b) {
  return within(a - b, kSameGeometry);
}

bool same_fan(const PingGeometry& ping, const PingGeometry& other) {
  return ping.num_beams == other.num_beams && same(ping.first_bearing, other.first_bearing) &&
         same(ping.bearing_step, other.bearing_step);
}

bool same_fan(const PingGeometry& ping, const core::SonarParams& configured) {
  if (configured.fan) return configured.fan->fits(ping.num_beams, ping.first_bearing, ping.bearing_step);
  return ping.num_beams == configured.num_beams && same(ping.first_bearing, configured.first_bearing) &&
         same(ping.bearing_step, configured.bearing_step);
}

template <class Other>
bool same_sector(const PingGeometry& ping, const Other& other) {
  return same_fan(ping, other) && same(ping.T_body_sonar.north, other.T_body_sonar.north) &&
         same(ping.T_body_sonar.east, other.T_body_sonar.east) &&
         same(ping.T_body_sonar.heading, other.T_body_sonar.heading);
}

bool is_silent(const core::SonarReturn& one) {
  return !std::isfinite(one.range) || !std::isfinite(one.bearing) || one.range == 0.0;
}

/// Whether returns at the very maximum are beams that heard nothing: one may be an echo.
bool is_silence_at_maximum(const core::SonarScan& scan) {
  return std::count_if(scan.returns.begin(), scan.returns.end(),
                       [&scan](const auto& one) { return one.range == scan.max_range; }) >= kFewestAtMaximum;
}

/// Turns the bearing of a return into the sector's own turn; false where the return lies outside sector or
/// range.
bool bring_into_sector(const core::SonarScan& scan, core::SonarReturn& one) {
  if (!positive_below(one.range, scan.max_range) || !within(one.bearing, PingLimits::kMaxAngle)) return false;
  const double middle = scan.first_bearing + 0.5 * (scan.num_beams - 1) * scan.bearing_step;
  const double offset = one.bearing - middle;
  // Left as it came where it is near already: the same bits in every way that a scan can take.
  if (!within(offset, std::numbers::pi)) one.bearing = middle + std::remainder(offset, kFullTurn);
  const int beam = beam_of(scan, one.bearing);
  return beam >= 0 && beam < scan.num_beams;
}

}  // namespace

int beam_of(const core::SonarScan& scan, double bearing) {
  if (scan.fan) return scan.fan->beam_of(bearing);
  return static_cast<int>(std::lround((bearing - scan.first_bearing) / scan.bearing_step));
}

std::string_view defect(const core::SonarScan& scan) {
  if (const auto header = header_defect(scan, scan.num_beams); !header.empty()) return header;
  if (!within(scan.first_bearing, kFullTurn) || !positive_below(scan.bearing_step, kFullTurn) ||
      scan.num_beams * scan.bearing_step > kFullTurn * (1.0 + kSameGeometry))
    return "bearings out of range";
  if (!positive_below(scan.max_range, PingLimits::kMaxRange) || scan.max_range < core::SonarLimits::kMinRange)
    return "maximum range out of range";
  return {};
}

std::string_view defect(const core::SonarImage& image) {
  if (const auto header = header_defect(image, image.num_beams()); !header.empty()) return header;
  if (!core::is_beam_table(image.bearings) || !within(image.bearings.front(), kFullTurn) ||
      !within(image.bearings.back(), kFullTurn))
    return "bearings out of range";
  if (!within(image.first_range, PingLimits::kMaxRange) ||
      !positive_below(image.range_step, PingLimits::kMaxRange) || image.num_bins < 1)
    return "ranges out of range";
  const std::size_t pixels = image.bearings.size() * static_cast<std::size_t>(image.num_bins);
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

DroppedReturns drop_returns(core::SonarScan& scan) {
  DroppedReturns dropped;
  const bool at_maximum = is_silence_at_maximum(scan);
  std::size_t kept = 0;
  for (core::SonarReturn& one : scan.returns) {
    if (!std::isfinite(one.intensity)) one.intensity = core::SonarReturn().intensity;
    if (is_silent(one) || (at_maximum && one.range == scan.max_range))
      ++dropped.silent;
    else if (!bring_into_sector(scan, one))
      ++dropped.out_of_bounds;
    else
      scan.returns[kept++] = one;
  }
  scan.returns.resize(kept);
  return dropped;
}

DroppedReturns drop_returns(core::SonarImage& /*image*/) {
  return {};
}

SameRange same_range(const core::SonarScan& scan) {
  SameRange same;
  for (const core::SonarReturn& one : scan.returns) {  // What more than half are is left by a vote in pairs.
    if (same.count == 0) same.range = one.range;
    same.count += one.range == same.range ? 1 : -1;
  }
  same.count = static_cast<int>(std::count_if(scan.returns.begin(), scan.returns.end(),
                                              [&same](const auto& one) { return one.range == same.range; }));
  const bool is_most = 2 * static_cast<std::size_t>(same.count) > scan.returns.size();
  return scan.returns.size() >= kFewestReturns && is_most ? same : SameRange{};
}

SameRange same_range(const core::SonarImage& /*image*/) {
  return {};
}

PingGeometry geometry_of(const core::SonarScan& scan) {
  return {scan.T_body_sonar, scan.first_bearing, scan.bearing_step, scan.max_range, scan.num_beams};
}

PingGeometry geometry_of(const core::SonarImage& image) {
  const double max_range = image.first_range + image.num_bins * image.range_step;
  return {image.T_body_sonar, image.bearings.front(), core::mean_step(image.bearings), max_range,
          image.num_beams()};
}

bool same(const PingGeometry& a, const PingGeometry& b) {
  return same_sector(a, b) && same(a.max_range, b.max_range);
}

bool agrees(const core::SonarScan& scan, const core::SonarParams& configured) {
  return same_sector(geometry_of(scan), configured) && same(scan.max_range, configured.max_range);
}

bool agrees(const core::SonarImage& image, const core::SonarParams& configured) {
  return same_sector(geometry_of(image), configured);
}

}  // namespace lookout::tracking
