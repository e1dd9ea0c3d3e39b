// Speed of the forms of the histogram PMHT at 300 x 300, four iterations, one target, as ratios in one run;
// and of a whole sonar ping with eight targets.
//   track_before_detect_benchmark --benchmark_min_time=1
#include <benchmark/benchmark.h>

#include "sonar_sim/sonar_simulator.hpp"
#include "tests/tracking/track_before_detect/frame_maker.hpp"
#include "tracking/track_before_detect/frames/h_pmht.hpp"
#include "tracking/track_before_detect/images/image_tracker.hpp"

namespace lookout::tracking {
namespace {

constexpr int kSize = 300;

void one_scan(benchmark::State& state, CellForm form, Truncation truncation) {
  core::Random random(1000);
  const IntensityFrame frame = noisy_frame(kSize, kSize, {144, 146}, random);
  HPmhtParams params = improved_h_pmht_4();
  params.form = form;
  params.truncation = truncation;
  const auto tracker = make_h_pmht(params);
  tracker->add(1, {152.0, 150.0, 0.0, 0.0}, Eigen::Vector4d(4.0, 4.0, 0.04, 0.04).asDiagonal());
  const double step = 1.0;
  for (auto _ : state) benchmark::DoNotOptimize(tracker->process({&frame, 1}, {&step, 1}).data());
}

/// The E-steps alone, prepared once a frame as in a scan: the frame's check against damage left out.
void four_iterations(benchmark::State& state, CellForm form, Truncation truncation) {
  core::Random random(1000);
  const IntensityFrame frame = noisy_frame(kSize, kSize, {144, 146}, random);
  const double threshold = displayed_threshold(frame.noise_level, 5.0);
  const auto e_step = make_cell_expectation(form, truncation);
  const CellModel model{{152.0, 150.0}, {7.6, 7.6}, 0.95};
  for (auto _ : state) {
    e_step->prepare(frame, threshold);
    for (int i = 0; i < 4; ++i)
      benchmark::DoNotOptimize(e_step->evaluate(0.05, {&model, 1}).total_probability);
  }
}

void sonar_ping(benchmark::State& state) {
  const auto scene = sonar_sim::parse_scene(R"(
duration: 30.0
sonar: {miss_probability: 0.3, false_alarm_probability: 0.05}
image: {snr_db: 14.0}
targets:
  - {id: 1, north: 40.0, east: -20.0}
  - {id: 2, north: 60.0, east: 20.0}
  - {id: 3, north: 80.0, east: 0.0}
  - {id: 4, north: 100.0, east: -40.0}
  - {id: 5, north: 110.0, east: 40.0}
  - {id: 6, north: 130.0, east: 10.0}
  - {id: 7, north: 90.0, east: -60.0}
  - {id: 8, north: 70.0, east: 50.0}
)",
                                            "benchmark");
  sonar_sim::SonarSimulator simulator(scene, 1000);
  std::vector<core::PosedImage> pings;
  while (const auto ping = simulator.next()) pings.push_back({*ping->image, ping->T_earth_sonar});
  ImageTracker tracker;
  std::size_t next = 0;
  std::int64_t utime = 0;
  for (auto _ : state) {
    core::PosedImage& ping = pings[next++ % pings.size()];
    ping.image.utime = utime += 500000;
    benchmark::DoNotOptimize(tracker.update(ping).data());
  }
  state.counters["tracks"] = static_cast<double>(tracker.tracks().size());
  // Pings come at 2 Hz: how many times faster than real time this is.
  state.counters["times_real_time"] = benchmark::Counter(0.5, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK_CAPTURE(four_iterations, per_cell, CellForm::per_cell, Truncation::impute);
BENCHMARK_CAPTURE(four_iterations, separable, CellForm::separable, Truncation::impute);
BENCHMARK_CAPTURE(four_iterations, sparse, CellForm::sparse, Truncation::impute);
BENCHMARK_CAPTURE(four_iterations, gated, CellForm::gated, Truncation::zero);
BENCHMARK_CAPTURE(one_scan, per_cell, CellForm::per_cell, Truncation::impute);
BENCHMARK_CAPTURE(one_scan, separable, CellForm::separable, Truncation::impute);
BENCHMARK_CAPTURE(one_scan, sparse, CellForm::sparse, Truncation::impute);
BENCHMARK_CAPTURE(one_scan, gated, CellForm::gated, Truncation::zero);
BENCHMARK(sonar_ping);

}  // namespace
}  // namespace lookout::tracking

BENCHMARK_MAIN();
