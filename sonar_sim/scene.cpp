#include "sonar_sim/scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/field_of_view.hpp"
#include "core/files/yaml_reader.hpp"
#include "sonar_sim/image/image_section.hpp"
#include "sonar_sim/sea/sea_reader.hpp"

namespace lookout::sonar_sim {
namespace {

using core::kNotNegative;
using core::kPositive;
using core::YamlMap;

constexpr double kMostScans = 1e7;
/// Returns of one scan that no sonar makes: above them a scene is a mistake
/// that fills the memory.
constexpr int kMaxReturns = 100'000;

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
  faults.drift.heading_bias = core::radians(map.number("heading_bias_deg", 0.0, {-180, 180}));
  faults.drift.heading_drift = core::radians(map.number("heading_drift_deg", 0.0, {-90, 90}));
  faults.drift.heading_walk = core::radians(map.number("heading_walk_deg", 0.0, {0, 90}));
  faults.drift.position_walk = map.number("position_walk", 0.0, {0, 1000});
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

std::vector<RangeSetting> read_range_settings(const YamlMap& map) {
  std::vector<RangeSetting> settings;
  for (const auto& entry : map.maps("range_settings")) {
    settings.push_back(
        {entry.required_number("time", kPositive), entry.required_number("max_range", kPositive)});
    if (settings.size() > 1 && settings.back().time <= settings[settings.size() - 2].time)
      entry.fail("time", "must be later than that of the setting before");
    entry.finish();
  }
  return settings;
}

/// What a beam reports of all that it hears.
void read_returns_per_beam(const YamlMap& map, SonarPlan& sonar) {
  sonar.returns_per_beam = map.integer("returns_per_beam", 1, {1, 1000});
  const std::string keep = map.choice("keep", "precedence", {"precedence", "nearest", "strongest"});
  if (keep == "nearest") sonar.keep = Keep::nearest;
  if (keep == "strongest") sonar.keep = Keep::strongest;
}

void check_sonar(const YamlMap& map, const SonarPlan& sonar) {
  const core::SonarParams& params = sonar.params;
  if (params.latency > 0.0)
    map.fail("latency", "is of real sensors, expected 0: a simulated scan is never late");
  if (params.resolution > 0.0)
    map.fail("resolution", "is of real sensors, expected 0: simulated returns never merge");
  if (!params.miss_probability) map.fail("miss_probability", "is missing, expected a number >= 0 <= 1");
  if (!params.false_alarm_probability && !params.point_sensor())
    map.fail("false_alarm_probability", "is missing, expected it or clutter_per_scan");
  if (sonar.clutter == ClutterReading::light && params.false_alarm_probability.value_or(0.0) >= 1.0)
    map.fail("false_alarm_probability", "must be below 1 under light clutter");
  if (params.num_beams * sonar.returns_per_beam > kMaxReturns)
    map.fail("returns_per_beam", "num_beams x returns_per_beam is above 100000");
  for (const char* key : {"returns_per_beam", "keep"})
    if (params.point_sensor() && map.has(key))
      map.fail(key,
               "is of sonars with beams: a sensor with clutter_per_scan "
               "reports all that it hears");
}

/// @param sea the scene's, which the sonar's own `sea` changes key by key.
SonarPlan read_sonar(const YamlMap& map, const SeaSection& sea) {
  SonarPlan sonar;
  const std::string clutter = map.choice("clutter", "literal", {"literal", "light"});
  sonar.clutter = clutter == "light" ? ClutterReading::light : ClutterReading::literal;
  const auto echo_sigma = map.optional_number("echo_range_sigma", kNotNegative);
  sonar.quantise_bearing = map.flag("quantise_bearing", true);
  if (map.has("sensor_id")) sonar.sensor_id = map.integer("sensor_id", 0, {-1e9, 1e9});
  sonar.first_scan = map.number("first_scan", 0.0, kNotNegative);
  sonar.range_settings = read_range_settings(map);
  read_returns_per_beam(map, sonar);
  const auto own_sea = map.map("sea");
  core::read_sonar_params(map, sonar.params);
  sonar.echo_range_sigma = echo_sigma.value_or(sonar.params.range_sigma);
  check_sonar(map, sonar);
  sonar.sea = read_sea(sea, own_sea, sonar);
  if (sonar.keep == Keep::strongest && !sonar.sea.fluctuation)
    map.fail("keep", "strongest needs intensities, expected `fluctuation` in the sea");
  return sonar;
}

/// `sonar`, or the list `sonars` in its place.
void read_sonars(const YamlMap& map, const SeaSection& sea, PlatformPlan& platform) {
  if (const auto sonar = map.map("sonar")) {
    if (map.has("sonars")) map.fail("sonars", "stands in place of sonar");
    platform.sonar = read_sonar(*sonar, sea);
    return;
  }
  if (!map.has("sonars")) map.fail("sonar", "is missing, expected a mapping");
  std::set<std::int32_t> ids;
  for (const auto& entry : map.maps("sonars")) {
    SonarPlan sonar = read_sonar(entry, sea);
    if (!sonar.sensor_id) sonar.sensor_id = static_cast<std::int32_t>(ids.size()) + 1;
    if (!ids.insert(*sonar.sensor_id).second) entry.fail("sensor_id", "is used twice on one vehicle");
    if (ids.size() == 1)
      platform.sonar = std::move(sonar);
    else
      platform.further_sonars.push_back(std::move(sonar));
  }
  if (ids.empty()) map.fail("sonars", "expected at least one sonar");
}

PlatformPlan read_platform(const YamlMap& map, const SeaSection& sea) {
  PlatformPlan platform;
  if (const auto vehicle = map.map("vehicle")) platform.vehicle = read_vehicle(*vehicle);
  read_sonars(map, sea, platform);
  if (const auto image = map.map("image")) platform.image = read_image(*image, platform.sonar);
  return platform;
}

std::vector<PlatformPlan> read_platforms(const YamlMap& map, const SeaSection& sea) {
  if (!map.has("vehicles")) return {read_platform(map, sea)};
  if (map.has("vehicle") || map.has("sonar") || map.has("sonars") || map.has("image"))
    map.fail("vehicles", "stands in place of vehicle, sonar, sonars and image");
  std::vector<PlatformPlan> platforms;
  std::set<std::int32_t> node_ids;
  std::set<std::string> prefixes;
  for (const auto& entry : map.maps("vehicles")) {
    PlatformPlan platform = read_platform(entry, sea);
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
  scene.platforms = read_platforms(map, SeaSection(map.map("sea")));
  for (const auto& platform : scene.platforms)
    for (const SonarPlan* sonar : all_sonars(platform)) {
      if (num_scans(scene, *sonar) == 0) map.fail("duration", "ends before the first_scan of a sonar");
      if (scene.duration / sonar->params.scan_period > kMostScans)
        map.fail("duration", "holds more than 10 million scans of the sonar's scan_period");
    }
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

std::vector<const SonarPlan*> all_sonars(const PlatformPlan& platform) {
  std::vector<const SonarPlan*> sonars{&platform.sonar};
  for (const auto& sonar : platform.further_sonars) sonars.push_back(&sonar);
  return sonars;
}

core::SonarParams params_at(const SonarPlan& sonar, double time) {
  core::SonarParams params = sonar.params;
  for (const auto& setting : sonar.range_settings)
    if (time >= setting.time) params.max_range = setting.max_range;
  return params;
}

int num_scans(const Scene& scene, const SonarPlan& sonar) {
  // A hair below the quotient, so that a duration of a whole number of periods
  // does not gain a scan by rounding.
  const double periods = (scene.duration - sonar.first_scan) / sonar.params.scan_period;
  return std::max(0, static_cast<int>(std::ceil(periods - 1e-9)));
}

int num_scans(const Scene& scene, const PlatformPlan& platform) {
  int count = 0;
  for (const SonarPlan* sonar : all_sonars(platform)) count += num_scans(scene, *sonar);
  return count;
}

core::GroundTruth truth_at(const Scene& scene, const PlatformPlan& platform, const VehicleMotion& motion,
                           double time) {
  const core::Pose2 T_earth_body = motion.at(time).T_earth_body;
  const auto in_view = [&](const Eigen::Vector2d& p_earth) {
    const auto sonars = all_sonars(platform);
    return std::any_of(sonars.begin(), sonars.end(), [&](const SonarPlan* sonar) {
      const core::SonarParams params = params_at(*sonar, time);
      return core::observe(params, core::compose(T_earth_body, params.T_body_sonar), p_earth).visible();
    });
  };
  core::GroundTruth truth;
  truth.utime = core::microseconds(time);
  for (const auto& plan : scene.targets) {
    if (!plan.present(time)) continue;
    const TargetState state = target_state(plan, time);
    truth.targets.push_back({plan.id, state.position, state.velocity, in_view(state.position)});
  }
  return truth;
}

double mean_visible_targets(const Scene& scene, const PlatformPlan& platform) {
  const VehicleMotion motion(platform.vehicle);
  const int scans = num_scans(scene, platform.sonar);
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
