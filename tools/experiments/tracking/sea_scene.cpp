#include "tools/experiments/tracking/sea_scene.hpp"

#include <array>
#include <numbers>

#include "core/field_of_view.hpp"
#include "core/random.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {
namespace {

constexpr std::array kConditions{"uniform",    "spill",        "patch",        "bottom", "rocks",
                                 "wall",       "quay",         "dropout",      "burst",  "heavy_tails",
                                 "range_loss", "heading_bias", "heading_walk", "all"};
constexpr std::array kAppear{0.0, 0.0, 10.0, 20.0};   // s
constexpr double kNearest = 40.0, kFarthest = 150.0;  // m
constexpr double kSlowest = 0.8, kFastest = 1.3;      // m/s
constexpr double kSigma = 3.0;                        // m, of the echoes and as told
/// Keeps the draws of targets apart from the trackers' seeds.
constexpr std::uint64_t kTargetDraws = std::uint64_t{1} << 40;

bool in_view(const sonar_sim::Scene& scene, const sonar_sim::TargetPlan& target, double time) {
  const auto& platform = scene.platforms.front();
  const core::SonarParams& params = platform.sonar.params;
  const sonar_sim::VehicleMotion motion(platform.vehicle);
  const auto T_earth_sonar = core::compose(motion.at(time).T_earth_body, params.T_body_sonar);
  const auto seen = core::observe(params, T_earth_sonar, target_state(target, time).position);
  return seen.visible() && seen.range >= kNearest && seen.range <= kFarthest;
}

sonar_sim::TargetPlan draw_target(double half_side, core::Random& random) {
  sonar_sim::TargetPlan target;
  target.position = {random.uniform(-half_side, half_side), random.uniform(-half_side, half_side)};
  const double speed = random.uniform(kSlowest, kFastest);
  target.velocity = core::from_polar(speed, random.uniform(-std::numbers::pi, std::numbers::pi));
  return target;
}

sonar_sim::TargetPlan draw_target_in_view(const sonar_sim::Scene& scene, double appear,
                                          core::Random& random) {
  while (true) {
    sonar_sim::TargetPlan target = draw_target(2.0 * kFarthest, random);
    target.appear = appear;
    if (in_view(scene, target, appear) && in_view(scene, target, 0.5 * (appear + scene.duration)))
      return target;
  }
}

}  // namespace

std::span<const char* const> sea_conditions() {
  return kConditions;
}

sonar_sim::Scene sea_scene(const std::string& condition, double p_false_alarm, double p_miss,
                           std::uint64_t seed, int run) {
  auto scene = load_variant("sea_" + condition + ".yaml", {p_false_alarm, p_miss, kSigma});
  core::Random random(seed, core::RandomStream::experiment, kTargetDraws | static_cast<std::uint64_t>(run));
  scene.targets.clear();
  for (const double appear : kAppear) {
    scene.targets.push_back(draw_target_in_view(scene, appear, random));
    scene.targets.back().id = static_cast<std::int32_t>(scene.targets.size());
  }
  return scene;
}

}  // namespace lookout::tools
