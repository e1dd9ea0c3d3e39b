#include "tools/experiments/tracking/sea_scene.hpp"

#include <array>
#include <numbers>

#include "core/field_of_view.hpp"
#include "core/input_error.hpp"
#include "core/random.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {
namespace {

constexpr std::array kConditions{"uniform",    "spill",     "patch",        "bottom",       "rocks",
                                 "wall",       "quay",      "dropout",      "burst",        "heavy_tails",
                                 "range_loss", "swerling1", "heading_bias", "heading_walk", "all"};
constexpr std::array kTargets{"staying", "near"};
constexpr std::array kAppear{0.0, 0.0, 10.0, 20.0};   // s
constexpr double kNearest = 40.0, kFarthest = 150.0;  // m
constexpr double kNear = 80.0;                        // m: the farthest that near targets come
constexpr double kSlowest = 0.8, kFastest = 1.3;      // m/s
constexpr double kSigma = 3.0;                        // m, of the echoes and as told
/// Keeps the draws of targets apart from the trackers' seeds.
constexpr std::uint64_t kTargetDraws = std::uint64_t{1} << 40;

core::Pose2 sonar_at(const sonar_sim::Scene& scene, double time) {
  const auto& platform = scene.platforms.front();
  const sonar_sim::VehicleMotion motion(platform.vehicle);
  return core::compose(motion.at(time).T_earth_body, platform.sonar.params.T_body_sonar);
}

bool in_view(const sonar_sim::Scene& scene, const sonar_sim::TargetPlan& target, double time) {
  const auto seen = core::observe(scene.platforms.front().sonar.params, sonar_at(scene, time),
                                  target_state(target, time).position);
  return seen.visible() && seen.range >= kNearest && seen.range <= kFarthest;
}

Eigen::Vector2d draw_velocity(core::Random& random) {
  const double speed = random.uniform(kSlowest, kFastest);
  return core::from_polar(speed, random.uniform(-std::numbers::pi, std::numbers::pi));
}

sonar_sim::TargetPlan draw_staying(const sonar_sim::Scene& scene, double appear, core::Random& random) {
  while (true) {
    sonar_sim::TargetPlan target;
    constexpr double kHalfSide = 2.0 * kFarthest;
    target.position = {random.uniform(-kHalfSide, kHalfSide), random.uniform(-kHalfSide, kHalfSide)};
    target.velocity = draw_velocity(random);
    target.appear = appear;
    if (in_view(scene, target, appear) && in_view(scene, target, 0.5 * (appear + scene.duration)))
      return target;
  }
}

sonar_sim::TargetPlan draw_near(const sonar_sim::Scene& scene, double appear, core::Random& random) {
  const core::SonarParams& params = scene.platforms.front().sonar.params;
  const double range = random.uniform(kNearest, kNear);
  const double bearing = random.uniform(params.left_edge(), params.right_edge());
  sonar_sim::TargetPlan target;
  target.appear = appear;
  target.velocity = draw_velocity(random);
  const Eigen::Vector2d first = core::transform(sonar_at(scene, appear), core::from_polar(range, bearing));
  target.position = first - appear * target.velocity;  // At time 0, before it appears.
  return target;
}

using Draw = sonar_sim::TargetPlan (*)(const sonar_sim::Scene&, double, core::Random&);

Draw draw_of(const std::string& targets) {
  if (targets == kTargets[0]) return draw_staying;
  if (targets == kTargets[1]) return draw_near;
  throw core::InputError("unknown targets `" + targets + "`, accepted: staying near");
}

}  // namespace

std::span<const char* const> sea_conditions() {
  return kConditions;
}

std::span<const char* const> sea_targets() {
  return kTargets;
}

sonar_sim::Scene sea_scene(const SeaSetting& setting, std::uint64_t seed, int run) {
  auto scene =
      load_variant("sea_" + setting.condition + ".yaml", {setting.p_false_alarm, setting.p_miss, kSigma});
  core::Random random(seed, core::RandomStream::experiment, kTargetDraws | static_cast<std::uint64_t>(run));
  const auto draw = draw_of(setting.targets);
  scene.targets.clear();
  for (const double appear : kAppear) {
    scene.targets.push_back(draw(scene, appear, random));
    scene.targets.back().id = static_cast<std::int32_t>(scene.targets.size());
  }
  return scene;
}

}  // namespace lookout::tools
