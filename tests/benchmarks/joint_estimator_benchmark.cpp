// Time per scan of the joint estimator in streaming use beside the faithful one, on the Table 7 scene; then
// its growth with the window, with the false alarms and with the targets.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "csht/estimator_registry.hpp"
#include "sonar_sim/scene.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace {

using namespace lookout;

sonar_sim::Scene table7(double probability_of_false_alarm, double probability_of_miss) {
  return tools::load_variant("tracking_table7.yaml", {probability_of_false_alarm, probability_of_miss, 3.0,
                                                      sonar_sim::ClutterReading::literal});
}

// `count` slow targets spread over the field of view, all in view throughout.
sonar_sim::Scene crowd(int count) {
  auto scene = tools::load_variant("empty_sea.yaml", {0.3, 0.3, 3.0, sonar_sim::ClutterReading::literal});
  scene.platforms.front().vehicle = {};  // At the origin, heading north.
  for (int k = 0; k < count; ++k) {
    const double bearing = core::radians(80.0 * (k + 0.5) / count - 40.0);
    sonar_sim::TargetPlan target;
    target.id = k + 1;
    target.position = core::from_polar(60.0 + 20.0 * (k % 4), bearing);
    target.velocity = core::from_polar(0.2, bearing);
    scene.targets.push_back(target);
  }
  return scene;
}

void stream(benchmark::State& state, const char* name, const sonar_sim::Scene& scene, int window_scans) {
  const auto scans = tools::simulate(scene, 1001, 0);
  csht::EstimatorParams params;
  params.window_scans = window_scans;
  const auto estimator =
      csht::make_estimator(name, params, sonar_sim::known_params(scene, scene.platforms.front()), 1);
  std::size_t next = 0;
  for (; next < static_cast<std::size_t>(window_scans); ++next) estimator->update(scans[next].posed);
  std::vector<double> times_ms;
  double found = 0.0;
  for (auto _ : state) {
    if (next == scans.size()) {
      state.SkipWithError("the scene is over: ask for fewer iterations");
      break;
    }
    const auto start = std::chrono::steady_clock::now();
    found += static_cast<double>(estimator->update(scans[next++].posed).size());
    times_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  if (times_ms.empty()) return;
  std::sort(times_ms.begin(), times_ms.end());
  state.counters["median_ms"] = times_ms[times_ms.size() / 2];
  state.counters["p99_ms"] = times_ms[times_ms.size() * 99 / 100];
  state.counters["elements"] = found / static_cast<double>(times_ms.size());
}

constexpr int kScans = 120;

#define LOOKOUT_STREAM(label, ...) \
  BENCHMARK_CAPTURE(stream, label, __VA_ARGS__)->Iterations(kScans)->Unit(benchmark::kMillisecond)

LOOKOUT_STREAM(joint_1_1, "joint", table7(0.1, 0.1), 20);
LOOKOUT_STREAM(joint_3_3, "joint", table7(0.3, 0.3), 20);
LOOKOUT_STREAM(joint_5_5, "joint", table7(0.5, 0.5), 20);
LOOKOUT_STREAM(joint_7_7, "joint", table7(0.7, 0.7), 20);
LOOKOUT_STREAM(csht_3_3, "csht", table7(0.3, 0.3), 20);
LOOKOUT_STREAM(csht_7_7, "csht", table7(0.7, 0.7), 20);
LOOKOUT_STREAM(joint_3_3_window_40, "joint", table7(0.3, 0.3), 40);
LOOKOUT_STREAM(joint_3_3_window_60, "joint", table7(0.3, 0.3), 60);
LOOKOUT_STREAM(joint_P_F_1_P_M_3, "joint", table7(0.1, 0.3), 20);
LOOKOUT_STREAM(joint_P_F_7_P_M_3, "joint", table7(0.7, 0.3), 20);
LOOKOUT_STREAM(joint_2_targets, "joint", crowd(2), 20);
LOOKOUT_STREAM(joint_4_targets, "joint", crowd(4), 20);
LOOKOUT_STREAM(joint_8_targets, "joint", crowd(8), 20);
LOOKOUT_STREAM(joint_16_targets, "joint", crowd(16), 20);

}  // namespace

BENCHMARK_MAIN();
