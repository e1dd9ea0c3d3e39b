#include "tools/experiments/tracking/sensor_knowledge.hpp"

#include <stdexcept>

#include "csht/joint/joint_estimator.hpp"

namespace lookout::tools {
namespace {

constexpr const char* kTeachingScene = "tracking_table7.yaml";
constexpr int kTeachingScans = 100;
constexpr int kTeachingWindow = 40;                     // A long one, for many misses.
constexpr std::uint64_t kOtherSeed = 7'000'000'000ULL;  // Far from every seed of a run.

double with_odds(double probability, double factor) {
  const double odds = factor * probability / (1.0 - probability);
  return odds / (1.0 + odds);
}

// The figures that an estimator which was told none learns from the stream of another scene.
core::SonarParams taught(core::SonarParams sonar, const SceneVariant& variant, std::uint64_t seed, int run) {
  auto scene = load_variant(kTeachingScene, variant);
  sonar.miss_probability.reset();
  sonar.false_alarm_probability.reset();
  scene.duration = kTeachingScans * sonar.scan_period;
  csht::JointEstimatorParams params;
  params.window_scans = kTeachingWindow;
  csht::JointEstimator estimator(params, sonar, seed);
  for (const auto& timed : simulate(scene, seed + kOtherSeed, run)) estimator.update(timed.posed);
  const auto estimate = estimator.sensor_estimate().value();
  sonar.miss_probability = estimate.miss_probability;
  sonar.false_alarm_probability = estimate.false_alarm_probability;
  return sonar;
}

}  // namespace

core::SonarParams told_params(const sonar_sim::Scene& scene, const SceneVariant& variant,
                              const std::string& sensor_figures, std::uint64_t seed, int run) {
  core::SonarParams sonar = sonar_sim::known_params(scene, scene.platforms.front());
  if (sensor_figures == "known") return sonar;
  if (sensor_figures == "unknown") return taught(sonar, variant, seed, run);
  if (sensor_figures != "half" && sensor_figures != "double")
    throw std::invalid_argument("sensor_figures must be known, unknown, half or double, got " +
                                sensor_figures);
  const double factor = sensor_figures == "half" ? 0.5 : 2.0;
  sonar.false_alarm_probability = with_odds(*sonar.false_alarm_probability, factor);
  sonar.miss_probability = with_odds(*sonar.miss_probability, factor);
  return sonar;
}

}  // namespace lookout::tools
