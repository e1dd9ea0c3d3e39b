#include "tools/experiments/harness/simulated_run.hpp"

#include <deque>
#include <stdexcept>
#include <string>

#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/paths.hpp"
#include "tracking/intake/scan_intake.hpp"

namespace lookout::tools {

std::vector<TimedScan> simulate(const sonar_sim::Scene& scene, std::uint64_t seed, int run,
                                std::size_t platform) {
  sonar_sim::SonarSimulator simulator(scene, seed, static_cast<std::uint64_t>(run), platform);
  std::vector<TimedScan> scans;
  core::PoseHistory history;
  while (auto simulated = simulator.next()) {
    for (const auto& state : simulated->states_before) history.add(state);
    for (const auto& state : simulated->states_after) history.add(state);
    const auto body = history.at(simulated->scan.utime);
    if (!body) continue;
    const core::Pose2 T_earth_sonar = core::compose(*body, simulated->scan.T_body_sonar);
    scans.push_back({{std::move(simulated->scan), T_earth_sonar}, std::move(simulated->truth)});
  }
  return scans;
}

std::vector<TimedScan> simulate_through_intake(const sonar_sim::Scene& scene, std::uint64_t seed, int run,
                                               std::size_t platform) {
  sonar_sim::SonarSimulator simulator(scene, seed, static_cast<std::uint64_t>(run), platform);
  std::vector<TimedScan> scans;
  std::deque<core::GroundTruth> truth;  // Of scans that the intake may still hand out.
  const auto take = [&](const core::PosedScan& posed) {
    while (truth.front().utime < posed.scan.utime) truth.pop_front();
    scans.push_back({posed, std::move(truth.front())});
    truth.pop_front();
  };
  const auto reset = [] { throw std::logic_error("a simulated clock never goes back"); };
  tracking::ScanIntake intake(scene.platforms[platform].sonar.params,
                              {take, reset, [](const std::string&) {}});
  while (auto simulated = simulator.next()) {
    for (const auto& state : simulated->states_before) intake.add(state);
    truth.push_back(std::move(simulated->truth));
    intake.add(std::move(simulated->scan));
    for (const auto& state : simulated->states_after) intake.add(state);
  }
  intake.finish();
  return scans;
}

sonar_sim::Scene load_variant(const std::string& scene_file, const SceneVariant& variant) {
  sonar_sim::Scene scene = sonar_sim::load_scene(tools_directory() + "/scenarios/" + scene_file);
  for (auto& platform : scene.platforms) {
    platform.sonar.params.false_alarm_probability = variant.p_false_alarm;
    platform.sonar.params.miss_probability = variant.p_miss;
    platform.sonar.params.range_sigma = variant.sigma;
    platform.sonar.echo_range_sigma = variant.sigma;
    platform.sonar.clutter = variant.clutter;
  }
  return scene;
}

void begin_earlier(double seconds, sonar_sim::Scene& scene) {
  const auto& vehicle = scene.platforms.front().vehicle;
  bool straight = scene.platforms.size() == 1 && vehicle.waypoints.empty() && vehicle.yaw_swing == 0.0;
  for (const auto& target : scene.targets)
    straight = straight && target.turn_rate == 0.0 && target.acceleration == 0.0 && target.appear <= 0.0;
  if (!straight)
    throw std::invalid_argument("begin_earlier needs one vehicle and targets that move straight throughout");
  scene.duration += seconds;
  auto& platform = scene.platforms.front();
  platform.vehicle.position -= seconds * platform.vehicle.velocity;
  for (auto& target : scene.targets) target.position -= seconds * target.velocity;
}

sonar_sim::ClutterReading clutter_reading(const std::string& name) {
  if (name == "literal") return sonar_sim::ClutterReading::literal;
  if (name == "light") return sonar_sim::ClutterReading::light;
  throw std::invalid_argument("clutter must be literal or light, got " + name);
}

}  // namespace lookout::tools
