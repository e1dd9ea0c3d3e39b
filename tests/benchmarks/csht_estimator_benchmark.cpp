// Time per scan of `csht`, its tracking set on the Table 7 scene once the window is full, P_M = .3, P_F = .1,
// .3, .5, .7 (the arguments, in tenths).
#include <benchmark/benchmark.h>

#include "csht/csht_estimator.hpp"
#include "sonar_sim/scene.hpp"
#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {
namespace {

void csht_scan(benchmark::State& state, sonar_sim::ClutterReading clutter) {
  const double probability = static_cast<double>(state.range(0)) / 10.0;
  const auto scene = load_variant("tracking_table7.yaml", {probability, 0.3, 3.0, clutter});
  const auto scans = simulate(scene, 1, 0);
  csht::CshtEstimator estimator(csht::CshtParams::tracking(),
                                sonar_sim::known_params(scene, scene.platforms.front()));
  std::size_t next = 0;
  for (; next < 40; ++next) estimator.update(scans[next].posed);
  for (auto _ : state) {
    if (next == scans.size()) {
      state.PauseTiming();
      estimator = csht::CshtEstimator(csht::CshtParams::tracking(),
                                      sonar_sim::known_params(scene, scene.platforms.front()));
      for (next = 0; next < 40; ++next) estimator.update(scans[next].posed);
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(estimator.update(scans[next].posed));
    ++next;
  }
}
BENCHMARK_CAPTURE(csht_scan, light, sonar_sim::ClutterReading::light)
    ->Arg(1)
    ->Arg(3)
    ->Arg(5)
    ->Arg(7)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(csht_scan, literal, sonar_sim::ClutterReading::literal)
    ->Arg(1)
    ->Arg(3)
    ->Arg(5)
    ->Arg(7)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lookout::tools

BENCHMARK_MAIN();
