#include "tools/experiments/track_before_detect/image_sea_scene.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "core/field_of_view.hpp"
#include "core/random.hpp"
#include "tools/cli/paths.hpp"

namespace lookout::tools {
namespace {

constexpr std::array kConditions{"plain",   "speckle",   "stripes", "bottom", "standing",
                                 "shadows", "swerling1", "uneven",  "all",    "empty"};
constexpr std::array kAppear{0.0, 0.0, 10.0};        // s
constexpr double kNearest = 12.0, kFarthest = 45.0;  // m
constexpr double kSlowest = 0.4, kFastest = 1.2;     // m/s
constexpr double kEdge = 0.05;                       // rad: a target keeps so far from the fan's edges
/// Keeps the draws of targets apart from those of other experiments and of the trackers.
constexpr std::uint64_t kTargetDraws = std::uint64_t{1} << 41;

bool in_view(const sonar_sim::Scene& scene, const sonar_sim::TargetPlan& target, double time) {
  const auto& platform = scene.platforms.front();
  const core::SonarParams& params = platform.sonar.params;
  const sonar_sim::VehicleMotion motion(platform.vehicle);
  const auto T_earth_sonar = core::compose(motion.at(time).T_earth_body, params.T_body_sonar);
  const auto seen = core::observe(params, T_earth_sonar, target_state(target, time).position);
  const bool inside = seen.bearing > params.left_edge() + kEdge && seen.bearing < params.right_edge() - kEdge;
  return inside && seen.range >= kNearest && seen.range <= kFarthest;
}

sonar_sim::TargetPlan draw_target(double appear, core::Random& random) {
  sonar_sim::TargetPlan target;
  target.appear = appear;
  target.position = {random.uniform(-kFarthest, 2.0 * kFarthest), random.uniform(-kFarthest, kFarthest)};
  const double speed = random.uniform(kSlowest, kFastest);
  target.velocity = core::from_polar(speed, random.uniform(-std::numbers::pi, std::numbers::pi));
  return target;
}

sonar_sim::TargetPlan draw_target_in_view(const sonar_sim::Scene& scene, double appear,
                                          core::Random& random) {
  while (true) {
    const sonar_sim::TargetPlan target = draw_target(appear, random);
    if (in_view(scene, target, appear) && in_view(scene, target, 0.5 * (appear + scene.duration)) &&
        in_view(scene, target, scene.duration))
      return target;
  }
}

/// Of the same length, in bins of another.
void use_range_step(double range_step, sonar_sim::ImagePlan& image) {
  image.num_bins = static_cast<int>(std::lround(image.num_bins * image.range_step / range_step));
  image.range_step = range_step;
}

}  // namespace

std::span<const char* const> image_sea_conditions() {
  return kConditions;
}

sonar_sim::Scene image_sea_scene(const std::string& condition, const ImageSeaSetting& setting,
                                 std::uint64_t seed, int run) {
  auto scene = sonar_sim::load_scene(tools_directory() + "/scenarios/image_" + condition + ".yaml");
  sonar_sim::ImagePlan& image = *scene.platforms.front().image;
  image.snr_db = setting.snr_db;
  use_range_step(setting.range_step, image);
  if (scene.targets.empty()) return scene;
  core::Random random(seed, core::RandomStream::experiment, kTargetDraws | static_cast<std::uint64_t>(run));
  scene.targets.clear();
  for (const double appear : kAppear) {
    scene.targets.push_back(draw_target_in_view(scene, appear, random));
    scene.targets.back().id = static_cast<std::int32_t>(scene.targets.size());
  }
  return scene;
}

}  // namespace lookout::tools
