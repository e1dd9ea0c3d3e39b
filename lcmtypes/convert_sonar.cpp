// What the sonar sends: scans and images.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "core/beam_order.hpp"
#include "core/sonar_limits.hpp"
#include "lcmtypes/convert.hpp"
#include "lcmtypes/wire_checks.hpp"

namespace lookout::lcmtypes {
namespace {

/// The same direction within a turn, as a recording has it; beyond PingLimits it stays, to be refused.
double within_a_turn(double heading) {
  constexpr double kTurn = 2.0 * std::numbers::pi, kMostAngle = 1e3;
  const bool is_wide = std::abs(heading) > kTurn && std::abs(heading) <= kMostAngle;
  return is_wide ? std::remainder(heading, kTurn) : heading;
}

/// What both kinds of ping have in common.
template <class Wire, class Core>
void copy_header_to_core(const Wire& wire, Core& ping) {
  ping.utime = wire.utime;
  ping.sequence = wire.sequence;
  ping.sensor_id = wire.sensor_id;
  ping.T_body_sonar = {wire.mount_x, wire.mount_y, within_a_turn(wire.mount_heading)};
}

template <class Core, class Wire>
void copy_header_to_wire(const Core& ping, Wire& wire) {
  wire.utime = ping.utime;
  wire.sequence = ping.sequence;
  wire.sensor_id = ping.sensor_id;
  wire.mount_x = ping.T_body_sonar.north;
  wire.mount_y = ping.T_body_sonar.east;
  wire.mount_heading = ping.T_body_sonar.heading;
}

bool header_finite(const sonar_scan_t& wire) {
  return all_finite({wire.mount_x, wire.mount_y, wire.mount_heading, wire.first_bearing, wire.bearing_step,
                     wire.max_range});
}

bool header_finite(const sonar_image_t& wire) {
  return all_finite({wire.mount_x, wire.mount_y, wire.mount_heading, wire.first_range, wire.range_step,
                     wire.intensity_scale}) &&
         all_finite(wire.bearing);
}

bool is_rectangular(const sonar_image_t& wire) {
  const auto is_full = [&wire](const auto& row) { return agrees(wire.num_bins, row.size()); };
  return agrees(wire.num_beams, wire.bearing.size()) && agrees(wire.num_beams, wire.intensity.size()) &&
         std::all_of(wire.intensity.begin(), wire.intensity.end(), is_full);
}

bool is_monotonic(const std::vector<double>& bearings) {
  const auto not_rising = [](double a, double b) { return !(b > a); };
  const auto not_falling = [](double a, double b) { return !(b < a); };
  return std::adjacent_find(bearings.begin(), bearings.end(), not_rising) == bearings.end() ||
         std::adjacent_find(bearings.begin(), bearings.end(), not_falling) == bearings.end();
}

void require_at_most(std::size_t size, std::size_t limit, const char* what) {
  if (size <= limit) return;
  throw std::length_error(std::string(what) + ": " + std::to_string(size) +
                          " do not fit one message, at most " + std::to_string(limit) + " do");
}

/// @throws std::length_error where the image is larger than a message, or its sizes disagree.
void check_size(const core::SonarImage& image) {
  require_at_most(image.bearings.size(), core::SonarLimits::kMaxBeams, "beams of an image");
  require_at_most(static_cast<std::size_t>(image.num_bins), core::SonarLimits::kMaxBins, "bins of an image");
  require_at_most(image.intensity.size(), kMaxPixels, "pixels of an image");
  if (image.intensity.size() != image.bearings.size() * static_cast<std::size_t>(image.num_bins))
    throw std::length_error("image: beams x bins disagrees with the intensities");
}

/// The step of the integers: the image's own where they fit it.
double wire_scale(const core::SonarImage& image) {
  constexpr double kLargest = std::numeric_limits<std::int16_t>::max();
  const double largest = core::largest_magnitude(image);
  if (image.intensity_scale > 0.0 && std::round(largest / image.intensity_scale) <= kLargest)
    return image.intensity_scale;
  return largest > 0.0 ? largest / kLargest : 1.0;
}

}  // namespace

Converted<core::SonarScan> to_core(const sonar_scan_t& wire) {
  if (!is_time(wire.utime)) return {{}, "scan: time out of range (nanoseconds? utime counts microseconds)"};
  if (!agrees(wire.num_returns, wire.bearing.size()) || !agrees(wire.num_returns, wire.range.size()) ||
      !agrees(wire.num_returns, wire.intensity.size()))
    return {{}, "scan: number of returns disagrees with their lists"};
  if (wire.bearing.size() > kMaxReturns) return {{}, "scan: too many returns"};
  if (!header_finite(wire)) return {{}, "scan: header not finite"};
  core::SonarScan scan;
  copy_header_to_core(wire, scan);
  scan.first_bearing = wire.first_bearing;
  scan.bearing_step = wire.bearing_step;
  scan.num_beams = wire.num_beams;
  core::count_from_port(scan);
  scan.max_range = wire.max_range;
  scan.returns.reserve(wire.bearing.size());
  for (std::size_t i = 0; i < wire.bearing.size(); ++i)
    scan.returns.push_back({wire.bearing[i], wire.range[i], wire.intensity[i]});
  return {std::move(scan), {}};
}

sonar_scan_t to_wire(const core::SonarScan& scan) {
  require_at_most(scan.returns.size(), kMaxReturns, "returns of a scan");
  sonar_scan_t wire{};
  copy_header_to_wire(scan, wire);
  wire.first_bearing = scan.first_bearing;
  wire.bearing_step = scan.bearing_step;
  wire.num_beams = static_cast<std::int16_t>(scan.num_beams);
  wire.max_range = scan.max_range;
  wire.num_returns = static_cast<std::int16_t>(scan.returns.size());
  for (const auto& sonar_return : scan.returns) {
    wire.bearing.push_back(sonar_return.bearing);
    wire.range.push_back(sonar_return.range);
    wire.intensity.push_back(sonar_return.intensity);
  }
  return wire;
}

Converted<core::SonarImage> to_core(const sonar_image_t& wire) {
  if (!is_time(wire.utime)) return {{}, "image: time out of range (nanoseconds? utime counts microseconds)"};
  if (!is_rectangular(wire)) return {{}, "image: beams or bins disagree with the intensities"};
  if (wire.intensity.size() * static_cast<std::size_t>(wire.num_bins) > kMaxPixels)
    return {{}, "image: too many pixels"};
  if (!header_finite(wire)) return {{}, "image: header not finite"};
  if (!is_monotonic(wire.bearing)) return {{}, "image: bearings not strictly monotonic"};
  if (!(wire.intensity_scale > 0.0)) return {{}, "image: intensity scale not above 0"};
  core::SonarImage image;
  copy_header_to_core(wire, image);
  image.bearings = wire.bearing;
  image.intensity_scale = wire.intensity_scale;
  image.first_range = wire.first_range;
  image.range_step = wire.range_step;
  image.num_bins = wire.num_bins;
  image.intensity.reserve(wire.intensity.size() * static_cast<std::size_t>(wire.num_bins));
  for (const auto& row : wire.intensity) {
    for (const std::int16_t level : row) image.intensity.push_back(wire.intensity_scale * level);
  }
  core::count_from_port(image);
  return {std::move(image), {}};
}

sonar_image_t to_wire(const core::SonarImage& image) {
  check_size(image);
  const auto num_bins = static_cast<std::size_t>(image.num_bins);
  sonar_image_t wire{};
  copy_header_to_wire(image, wire);
  wire.first_range = image.first_range;
  wire.range_step = image.range_step;
  wire.num_beams = static_cast<std::int16_t>(image.num_beams());
  wire.num_bins = static_cast<std::int16_t>(image.num_bins);
  wire.bearing = image.bearings;
  wire.intensity_scale = wire_scale(image);
  wire.intensity.assign(image.bearings.size(), std::vector<std::int16_t>(num_bins));
  for (std::size_t pixel = 0; pixel < image.intensity.size(); ++pixel)
    wire.intensity[pixel / num_bins][pixel % num_bins] =
        static_cast<std::int16_t>(std::lround(image.intensity[pixel] / wire.intensity_scale));
  return wire;
}

}  // namespace lookout::lcmtypes
