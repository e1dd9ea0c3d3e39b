#include "sonar_sim/scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/field_of_view.hpp"
#include "core/yaml_reader.hpp"

namespace lookout::sonar_sim {
namespace {

using core::kNotNegative;
using core::kPositive;
using core::YamlMap;

constexpr double kMostScans = 1e7;

Eigen::Vector2d read_vector(const YamlMap& map, const std::string& north, const std::string& east) {
  return {map.number(north, 0.0), map.number(east, 0.0)};
}

std::optional<double> read_heading(const YamlMap& map) {
  const auto degrees = map.optional_number("heading_deg", {-360, 360});
  if (!degrees) return std::nullopt;
  return core::radians(*degrees);
}

TargetPlan read_target(const YamlMap& map) {
  TargetPlan target;
  target.id = static_cast<std::int32_t>(map.integer("id", 0));
  if (!map.has("id")) map.fail("id", "is missing, expected a whole number");
  target.position = {map.required_number("north"), map.required_number("east")};
  target.velocity = read_vector(map, "north_velocity", "east_velocity");
  target.turn_rate = core::radians(map.number("turn_rate_deg", 0.0, {-90, 90}));
  target.acceleration = map.number("acceleration", 0.0, {-10, 10});
  target.snr_db = map.optional_number("snr_db", {-40, 80});
  target.appear = map.number("appear", target.appear);
  target.disappear = map.number("disappear", target.disappear);
  if (target.disappear <= target.appear) map.fail("disappear", "must be after appear");
  map.finish();
  return target;
}

NavigationFaults read_navigation(const YamlMap& map) {
  NavigationFaults faults;
  faults.position_sigma = map.number("position_sigma", 0.0, kNotNegative);
  faults.heading_sigma = core::radians(map.number("heading_sigma_deg", 0.0, kNotNegative));
  faults.time_jitter = map.number("time_jitter", 0.0, {0, 10});
  faults.loss_probability = map.number("loss_probability", 0.0, core::kProbability);
  faults.delay = map.number("delay", 0.0, {0, 60});
  map.finish();
  return faults;
}

Waypoint read_waypoint(const YamlMap& map) {
  Waypoint waypoint;
  waypoint.position = {map.required_number("north"), map.required_number("east")};
  waypoint.speed = map.number("speed", waypoint.speed, kPositive);
  waypoint.heading = read_heading(map);
  map.finish();
  return waypoint;
}

VehiclePlan read_vehicle(const YamlMap& map) {
  VehiclePlan vehicle;
  vehicle.position = read_vector(map, "north", "east");
  vehicle.velocity = read_vector(map, "north_velocity", "east_velocity");
  vehicle.heading = read_heading(map);
  vehicle.turn_rate =
      core::radians(map.number("turn_rate_deg", core::degrees(vehicle.turn_rate), {0, 180, true}));
  vehicle.yaw_swing = core::radians(map.number("yaw_swing_deg", 0.0, {0, 90}));
  vehicle.yaw_period = map.number("yaw_period", vehicle.yaw_period, kPositive);
  for (const auto& waypoint : map.maps("waypoints")) vehicle.waypoints.push_back(read_waypoint(waypoint));
  if (!vehicle.waypoints.empty() && (map.has("north_velocity") || map.has("east_velocity")))
    map.fail("waypoints", "excludes a velocity: the speed stands at each waypoint");
  if (const auto navigation = map.map("navigation")) vehicle.navigation = read_navigation(*navigation);
  map.finish();
  return vehicle;
}

SonarPlan read_sonar(const YamlMap& map) {
  SonarPlan sonar;
  const std::string clutter = map.choice("clutter", "literal", {"literal", "light"});
  sonar.clutter = clutter == "light" ? ClutterReading::light : ClutterReading::literal;
  const auto echo_sigma = map.optional_number("echo_range_sigma", kNotNegative);
  sonar.quantise_bearing = map.flag("quantise_bearing", true);
  core::read_sonar_params(map, sonar.params);
  sonar.echo_range_sigma = echo_sigma.value_or(sonar.params.range_sigma);
  if (sonar.params.latency > 0.0)
    map.fail("latency", "is of real sensors, expected 0: a simulated scan is never late");
  if (sonar.params.resolution > 0.0)
    map.fail("resolution", "is of real sensors, expected 0: simulated returns never merge");
  if (!sonar.params.miss_probability) map.fail("miss_probability", "is missing, expected a number >= 0 <= 1");
  if (!sonar.params.false_alarm_probability && !sonar.params.point_sensor())
    map.fail("false_alarm_probability", "is missing, expected it or clutter_per_scan");
  if (sonar.clutter == ClutterReading::light && sonar.params.false_alarm_probability.value_or(0.0) >= 1.0)
    map.fail("false_alarm_probability", "must be below 1 under light clutter");
  return sonar;
}

ImagePlan read_image(const YamlMap& map) {
  ImagePlan image;
  image.num_bins = map.integer("num_bins", image.num_bins, {1, 30000});
  image.range_step = map.number("range_step", image.range_step, kPositive);
  image.first_range = map.number("first_range", 0.5 * image.range_step, kPositive);
  image.beam_null = core::radians(map.number("beam_null_deg", core::degrees(image.beam_null), kPositive));
  image.pulse_sigma = map.number("pulse_sigma", image.pulse_sigma, kPositive);
  const std::string background = map.choice("background", "k", {"k", "rayleigh"});
  image.shape = map.number("shape", *image.shape, kPositive);
  if (background == "rayleigh") image.shape.reset();
  image.noise_level = map.number("noise_level", image.noise_level, kPositive);
  image.reverberation_level = map.number("reverberation_level", image.reverberation_level, kNotNegative);
  image.reverberation_range = map.number("reverberation_range", image.reverberation_range, kPositive);
  image.snr_db = map.number("snr_db", image.snr_db, {-40, 80});
  map.finish();
  return image;
}

PlatformPlan read_platform(const YamlMap& map) {
  PlatformPlan platform;
  if (const auto vehicle = map.map("vehicle")) platform.vehicle = read_vehicle(*vehicle);
  const auto sonar = map.map("sonar");
  if (!sonar) map.fail("sonar", "is missing, expected a mapping");
  platform.sonar = read_sonar(*sonar);
  if (const auto image = map.map("image")) platform.image = read_image(*image);
  return platform;
}

std::vector<PlatformPlan> read_platforms(const YamlMap& map) {
  if (!map.has("vehicles")) return {read_platform(map)};
  if (map.has("vehicle") || map.has("sonar") || map.has("image"))
    map.fail("vehicles", "stands in place of vehicle, sonar and image");
  std::vector<PlatformPlan> platforms;
  std::set<std::int32_t> node_ids;
  std::set<std::string> prefixes;
  for (const auto& entry : map.maps("vehicles")) {
    PlatformPlan platform = read_platform(entry);
    platform.channel_prefix = entry.text("channel_prefix", "");
    platform.node_id = entry.integer("node_id", static_cast<int>(platforms.size()) + 1, {1, 30000});
    if (!prefixes.insert(platform.channel_prefix).second) entry.fail("channel_prefix", "is used twice");
    if (!node_ids.insert(platform.node_id).second) entry.fail("node_id", "is used twice");
    entry.finish();
    platforms.push_back(std::move(platform));
  }
  if (platforms.empty()) map.fail("vehicles", "expected at least one vehicle");
  return platforms;
}

Scene read_scene(const YamlMap& map) {
  Scene scene;
  scene.duration = map.required_number("duration", {0, 1e6, true});
  scene.platforms = read_platforms(map);
  for (const auto& platform : scene.platforms)
    if (scene.duration / platform.sonar.params.scan_period > kMostScans)
      map.fail("duration", "holds more than 10 million scans of the sonar's scan_period");
  std::set<std::int32_t> ids;
  for (const auto& entry : map.maps("targets")) {
    scene.targets.push_back(read_target(entry));
    if (!ids.insert(scene.targets.back().id).second) entry.fail("id", "is used twice");
  }
  map.finish();
  return scene;
}

}  // namespace

Scene load_scene(const std::string& path) {
  return read_scene(YamlMap::load_file(path));
}

Scene parse_scene(const std::string& text, const std::string& name) {
  return read_scene(YamlMap::load_text(text, name));
}

int num_scans(const Scene& scene, const PlatformPlan& platform) {
  // A hair below the quotient, so that a duration of a whole number of periods does not gain a scan by
  // rounding.
  return static_cast<int>(std::ceil(scene.duration / platform.sonar.params.scan_period - 1e-9));
}

core::GroundTruth truth_at(const Scene& scene, const PlatformPlan& platform, const VehicleMotion& motion,
                           double time) {
  const core::SonarParams& params = platform.sonar.params;
  const core::Pose2 T_earth_sonar = core::compose(motion.at(time).T_earth_body, params.T_body_sonar);
  core::GroundTruth truth;
  truth.utime = core::microseconds(time);
  for (const auto& plan : scene.targets) {
    if (!plan.present(time)) continue;
    const TargetState state = target_state(plan, time);
    const bool visible = core::observe(params, T_earth_sonar, state.position).visible();
    truth.targets.push_back({plan.id, state.position, state.velocity, visible});
  }
  return truth;
}

double mean_visible_targets(const Scene& scene, const PlatformPlan& platform) {
  const VehicleMotion motion(platform.vehicle);
  const int scans = num_scans(scene, platform);
  std::ptrdiff_t visible = 0;
  for (int k = 0; k < scans; ++k) {
    const auto truth = truth_at(scene, platform, motion, k * platform.sonar.params.scan_period);
    visible +=
        std::count_if(truth.targets.begin(), truth.targets.end(), [](const auto& t) { return t.visible; });
  }
  return static_cast<double>(visible) / scans;
}

core::SonarParams known_params(const Scene& scene, const PlatformPlan& platform) {
  core::SonarParams params = platform.sonar.params;
  // A scan's pose lies midway between two reports with errors of their own.
  params.heading_sigma = platform.vehicle.navigation.heading_sigma / std::sqrt(2.0);
  params.position_sigma = platform.vehicle.navigation.position_sigma / std::sqrt(2.0);
  if (platform.sonar.clutter == ClutterReading::literal || !params.false_alarm_probability) return params;
  const double p_f = *params.false_alarm_probability;
  const double n = mean_visible_targets(scene, platform);
  params.false_alarm_probability =
      p_f / (1.0 - p_f) * (1.0 - *params.miss_probability) * n / (params.num_beams - n);
  return params;
}

}  // namespace lookout::sonar_sim
