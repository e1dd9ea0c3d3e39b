// Time per scan of the joint estimator in streaming use beside the faithful one, on the Table 7 scene; then
// its growth with the window and with the false alarms.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "csht/estimator_registry.hpp"
#include "sonar_sim/scene.hpp"
#include "tools/experiments/simulated_run.hpp"

namespace {

using namespace lookout;

void stream(benchmark::State& state, const char* name, double probability_of_false_alarm,
            double probability_of_miss, int window_scans) {
  const auto scene = tools::load_variant(
      "tracking_table7.yaml",
      {probability_of_false_alarm, probability_of_miss, 3.0, sonar_sim::ClutterReading::literal});
  const auto scans = tools::simulate(scene, 1001, 0);
  csht::EstimatorParams params;
  params.window_scans = window_scans;
  const auto estimator =
      csht::make_estimator(name, params, sonar_sim::known_params(scene, scene.platforms.front()), 1);
  std::size_t next = 0;
  for (; next < static_cast<std::size_t>(window_scans); ++next) estimator->update(scans[next].posed);
  std::vector<double> times_ms;
  for (auto _ : state) {
    if (next == scans.size()) {
      state.SkipWithError("the scene is over: ask for fewer iterations");
      break;
    }
    const auto start = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(estimator->update(scans[next++].posed).size());
    times_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  if (times_ms.empty()) return;
  std::sort(times_ms.begin(), times_ms.end());
  state.counters["median_ms"] = times_ms[times_ms.size() / 2];
  state.counters["p99_ms"] = times_ms[times_ms.size() * 99 / 100];
}

constexpr int kScans = 120;

#define LOOKOUT_STREAM(label, ...) \
  BENCHMARK_CAPTURE(stream, label, __VA_ARGS__)->Iterations(kScans)->Unit(benchmark::kMillisecond)

LOOKOUT_STREAM(joint_1_1, "joint", 0.1, 0.1, 20);
LOOKOUT_STREAM(joint_3_3, "joint", 0.3, 0.3, 20);
LOOKOUT_STREAM(joint_5_5, "joint", 0.5, 0.5, 20);
LOOKOUT_STREAM(joint_7_7, "joint", 0.7, 0.7, 20);
LOOKOUT_STREAM(csht_3_3, "csht", 0.3, 0.3, 20);
LOOKOUT_STREAM(csht_7_7, "csht", 0.7, 0.7, 20);
LOOKOUT_STREAM(joint_3_3_window_40, "joint", 0.3, 0.3, 40);
LOOKOUT_STREAM(joint_3_3_window_60, "joint", 0.3, 0.3, 60);
LOOKOUT_STREAM(joint_P_F_1_P_M_3, "joint", 0.1, 0.3, 20);
LOOKOUT_STREAM(joint_P_F_7_P_M_3, "joint", 0.7, 0.3, 20);

}  // namespace

BENCHMARK_MAIN();
