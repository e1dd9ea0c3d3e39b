// Processor time per scan of the whole chain (scan in, tracks out) of every tracker on the Table 7 scene,
// literal clutter, in five cells: mean, median, 99th percentile and the ratio to the Kalman
// baseline on the same scans.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tools/cli/thread_time.hpp"
#include "tools/experiments/harness/simulated_run.hpp"
#include "tools/experiments/tracking/scored_run.hpp"

namespace {

using namespace lookout;

constexpr std::uint64_t kSeed = 1001;

struct Scene {
  Scene(double p_false_alarm, double p_miss)
      : scene(tools::load_variant("tracking_table7.yaml", {.p_false_alarm = p_false_alarm,
                                                           .p_miss = p_miss,
                                                           .sigma = 3.0,
                                                           .clutter = sonar_sim::ClutterReading::literal})),
        sonar(sonar_sim::known_params(scene, scene.platforms[0])),
        scans(tools::simulate(scene, kSeed, 0)) {}
  sonar_sim::Scene scene;
  core::SonarParams sonar;
  std::vector<tools::TimedScan> scans;
};

/// Milliseconds of each update of one run.
std::vector<double> times_of(const std::string& name, const Scene& scene) {
  const auto pipeline = tools::pipeline_of(name, scene.sonar, kSeed);
  std::vector<double> times;
  for (const auto& scan : scene.scans) {
    const double start = tools::thread_time_ms();
    benchmark::DoNotOptimize(pipeline->step(scan.posed).tracks.data());
    times.push_back(tools::thread_time_ms() - start);
  }
  return times;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void time_per_scan(benchmark::State& state, const std::string& name, double p_false_alarm, double p_miss) {
  const Scene scene(p_false_alarm, p_miss);
  const double kalman = mean(times_of("kalman", scene));
  std::vector<double> times;
  for (auto _ : state) {
    times = times_of(name, scene);
    state.SetIterationTime(mean(times) * 1e-3);
  }
  state.counters["p50_ms"] = quantile(times, 0.5);
  state.counters["p99_ms"] = quantile(times, 0.99);
  state.counters["ratio_to_kalman"] = mean(times) / kalman;
}

}  // namespace

int main(int argc, char** argv) {
  for (const auto& name : tracking::tracker_names()) {
    for (const auto& [p_false_alarm, p_miss] :
         {std::pair{0.1, 0.3}, {0.3, 0.3}, {0.5, 0.3}, {0.7, 0.3}, {0.7, 0.7}}) {
      const std::string label = "scan/" + name +
                                "/p_false_alarm:" + std::to_string(p_false_alarm).substr(0, 3) +
                                "/p_miss:" + std::to_string(p_miss).substr(0, 3);
      benchmark::RegisterBenchmark(label.c_str(), time_per_scan, name, p_false_alarm, p_miss)
          ->UseManualTime()
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
