#include "core/sonar_params.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/beam_bearings.hpp"
#include "core/beam_order.hpp"
#include "core/files/csv.hpp"
#include "core/files/yaml_reader.hpp"
#include "core/sonar_limits.hpp"

namespace lookout::core {
namespace {

void read_degrees(const YamlMap& map, const std::string& key, double& value,
                  const Range& range = kAnyNumber) {
  if (const auto number = map.optional_number(key, range)) value = radians(*number);
}

void read_optional(const YamlMap& map, const std::string& key, std::optional<double>& value,
                   const Range& range) {
  if (const auto number = map.optional_number(key, range)) value = number;
}

using Limits = SonarLimits;
constexpr Range kRanges{Limits::kMinRange, Limits::kMaxRange};
constexpr Range kMounts{-Limits::kMaxMount, Limits::kMaxMount};
constexpr Range kRangeSigmas{Limits::kMinRangeSigma, Limits::kMaxRangeSigma};
constexpr Range kSpeeds{0.0, Limits::kMaxSpeed, true};
constexpr Range kScanPeriods{Limits::kMinScanPeriod, Limits::kMaxScanPeriod};
constexpr Range kPoseGaps{0.0, 600.0, true};
constexpr Range kWaits{0.0, 60.0};

constexpr double kMostDegrees = 360.0;
constexpr double kLeastStepDegrees = 1e-6;

/// The table of `beam_bearings_deg` [rad], from port, of beams that are counted from starboard too.
std::vector<double> read_table(const YamlMap& map) {
  constexpr const char* kKey = "beam_bearings_deg";
  std::vector<double> bearings = map.numbers(kKey);
  if (bearings.size() < 2) map.fail(kKey, "expected at least two bearings");
  if (map.has("first_bearing_deg") || map.has("bearing_step_deg"))
    map.fail(kKey, "excludes first_bearing_deg and bearing_step_deg: give one of them");
  if (bearings.size() > Limits::kMaxBeams) map.fail(kKey, "expected at most 30000 bearings");
  if (map.integer("num_beams", static_cast<int>(bearings.size())) != static_cast<int>(bearings.size()))
    map.fail("num_beams", "is not the number of beam_bearings_deg");
  if (bearings.back() < bearings.front()) std::reverse(bearings.begin(), bearings.end());
  for (double& bearing : bearings) {
    if (!(std::abs(bearing) <= kMostDegrees)) map.fail(kKey, "expected bearings from -360 to 360");
    bearing = radians(bearing);
  }
  if (!is_beam_table(bearings))
    map.fail(kKey, "expected bearings that rise or fall, within a full turn with half a beam at either end");
  return bearings;
}

void set_fan(std::vector<double> bearings, SonarParams& params) {
  params.num_beams = static_cast<int>(bearings.size());
  params.first_bearing = bearings.front();
  params.bearing_step = mean_step(bearings);
  params.fan = std::make_shared<const UnevenFan>(std::move(bearings));
}

void read_even_fan(const YamlMap& map, SonarParams& params) {
  params.num_beams = map.integer("num_beams", params.num_beams, {1, Limits::kMaxBeams});
  read_degrees(map, "first_bearing_deg", params.first_bearing, {-kMostDegrees, kMostDegrees});
  read_degrees(map, "bearing_step_deg", params.bearing_step, {-kMostDegrees, kMostDegrees});
  if (std::abs(params.bearing_step) < radians(kLeastStepDegrees))
    map.fail("bearing_step_deg", "is 0 or next to it, expected a millionth of a degree or more, either way");
  count_from_port(params);
  // What a file says of an even fan holds over the uneven one of a file before it, unless it is its mean.
  if (params.fan && !params.fan->fits(params.num_beams, params.first_bearing, params.bearing_step))
    params.fan.reset();
}

/// Degrees that read back to the bit, where there are such.
double degrees_of(double bearing) {
  const double near = degrees(bearing);
  for (const double candidate :
       {near, std::nextafter(near, -kMostDegrees), std::nextafter(near, kMostDegrees)})
    if (radians(candidate) == bearing) return candidate;
  return near;
}

std::string fan_to_yaml(const UnevenFan& fan) {
  std::string text = "beam_bearings_deg: [";
  for (int beam = 0; beam < fan.num_beams(); ++beam)
    text.append(beam > 0 ? ", " : "").append(shortest(degrees_of(fan.centre(beam))));
  return text.append("]\n");
}

void read_geometry(const YamlMap& map, SonarParams& params) {
  if (map.has("beam_bearings_deg"))
    set_fan(read_table(map), params);
  else
    read_even_fan(map, params);
  params.max_range = map.number("max_range", params.max_range, kRanges);
  params.T_body_sonar.north = map.number("mount_x", params.T_body_sonar.north, kMounts);
  params.T_body_sonar.east = map.number("mount_y", params.T_body_sonar.east, kMounts);
  read_degrees(map, "mount_heading_deg", params.T_body_sonar.heading, {-360, 360});
  if (params.num_beams * std::abs(params.bearing_step) > 2.0 * std::numbers::pi * (1.0 + 1e-9))
    map.fail("num_beams", "num_beams x bearing_step_deg is above 360 degrees");
}

}  // namespace

double SonarParams::bearing_sigma_or_default() const {
  return bearing_sigma.value_or(bearing_step / std::sqrt(12.0));
}

double SonarParams::bearing_sigma_at(int beam) const {
  const double sigma = bearing_sigma_or_default();
  return fan ? sigma * fan->width(beam) / fan->mean_step() : sigma;
}

double SonarParams::place_of(double bearing) const {
  if (fan) return fan->place_of(bearing) + 0.5;
  const double middle = 0.5 * (left_edge() + right_edge());
  const double offset = wrap_to_pi(bearing - middle) + middle - left_edge();
  return offset / bearing_step;
}

int SonarParams::beam_of(double bearing) const {
  const double beam = std::floor(place_of(bearing));
  return beam >= 0.0 && beam < num_beams ? static_cast<int>(beam) : -1;
}

void read_sonar_params(const YamlMap& map, SonarParams& params) {
  read_geometry(map, params);
  params.range_sigma = map.number("range_sigma", params.range_sigma, kRangeSigmas);
  if (const auto sigma = map.optional_number("bearing_sigma_deg", {0, 90, true}))
    params.bearing_sigma = radians(*sigma);
  read_degrees(map, "heading_sigma_deg", params.heading_sigma, {0, 90});
  params.position_sigma = map.number("position_sigma", params.position_sigma, kNotNegative);
  params.resolution = map.number("resolution", params.resolution, kNotNegative);
  params.max_speed = map.number("max_speed", params.max_speed, kSpeeds);
  params.wander = map.number("wander", params.wander, kNotNegative);
  params.scan_period = map.number("scan_period", params.scan_period, kScanPeriods);
  params.latency = map.number("latency", params.latency, {0, 60});
  params.max_pose_gap = map.number("max_pose_gap_s", params.max_pose_gap, kPoseGaps);
  params.max_wait = map.number("max_wait_s", params.max_wait, kWaits);
  read_optional(map, "miss_probability", params.miss_probability, kProbability);
  read_optional(map, "false_alarm_probability", params.false_alarm_probability, kProbability);
  read_optional(map, "clutter_per_scan", params.clutter_per_scan, kNotNegative);
  if (map.has("clutter_per_scan") && map.has("false_alarm_probability"))
    map.fail("clutter_per_scan", "excludes false_alarm_probability: give one of them");
  // The kind of clutter that is given last wins, so that a recording can override a configuration.
  if (map.has("clutter_per_scan")) params.false_alarm_probability.reset();
  if (map.has("false_alarm_probability")) params.clutter_per_scan.reset();
  map.finish();
}

void read_sonar_params(const std::string& path, SonarParams& params) {
  read_sonar_params(YamlMap::load_file(path), params);
}

std::string to_yaml(const SonarParams& params) {
  std::string text;
  const auto line = [&text](const std::string& key, double value) {
    text += key + ": " + shortest(value) + "\n";
  };
  line("num_beams", params.num_beams);
  if (params.fan) {
    text += fan_to_yaml(*params.fan);
  } else {
    line("first_bearing_deg", degrees(params.first_bearing));
    line("bearing_step_deg", degrees(params.bearing_step));
  }
  line("max_range", params.max_range);
  line("mount_x", params.T_body_sonar.north);
  line("mount_y", params.T_body_sonar.east);
  line("mount_heading_deg", degrees(params.T_body_sonar.heading));
  line("range_sigma", params.range_sigma);
  if (params.bearing_sigma) line("bearing_sigma_deg", degrees(*params.bearing_sigma));
  if (params.heading_sigma > 0.0) line("heading_sigma_deg", degrees(params.heading_sigma));
  if (params.position_sigma > 0.0) line("position_sigma", params.position_sigma);
  if (params.resolution > 0.0) line("resolution", params.resolution);
  line("max_speed", params.max_speed);
  if (params.wander > 0.0) line("wander", params.wander);
  line("scan_period", params.scan_period);
  if (params.latency > 0.0) line("latency", params.latency);
  const SonarParams defaults;
  if (params.max_pose_gap != defaults.max_pose_gap) line("max_pose_gap_s", params.max_pose_gap);
  if (params.max_wait != defaults.max_wait) line("max_wait_s", params.max_wait);
  if (params.miss_probability) line("miss_probability", *params.miss_probability);
  if (params.false_alarm_probability) line("false_alarm_probability", *params.false_alarm_probability);
  if (params.clutter_per_scan) line("clutter_per_scan", *params.clutter_per_scan);
  return text;
}

}  // namespace lookout::core
