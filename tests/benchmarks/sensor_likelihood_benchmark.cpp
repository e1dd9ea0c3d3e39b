// Nanoseconds per likelihood term (one hypothesis, one scan): vectorised against the plain loop.
#include <benchmark/benchmark.h>

#include "core/random.hpp"
#include "csht/likelihood/sensor_likelihood.hpp"

namespace {

using namespace lookout;

csht::ScanTable noisy_table(csht::ClutterModel clutter, double false_alarm_probability) {
  core::Random random(1001);
  core::PosedScan posed;
  posed.scan.num_beams = 90;
  posed.scan.first_bearing = core::radians(-44.5);
  posed.scan.bearing_step = core::radians(1.0);
  posed.scan.max_range = 150.0;
  for (int beam = 0; beam < 90; ++beam)
    if (random.bernoulli(false_alarm_probability))
      posed.scan.returns.push_back({core::radians(beam - 44.5), random.uniform(0.1, 150.0), 1.0});
  csht::ScanTable table;
  csht::fill_scan_table(posed, table);
  csht::set_figures({}, {.clutter = clutter}, table);
  return table;
}

struct Cloud {
  std::vector<double> north, east, north_velocity, east_velocity, sum;
  explicit Cloud(std::size_t size, double ahead = 80.0) : sum(size, 0.0) {
    core::Random random(1002);
    for (std::size_t i = 0; i < size; ++i) {
      north.push_back(ahead + random.gaussian(3.0));
      east.push_back(10.0 + random.gaussian(3.0));
      north_velocity.push_back(random.gaussian(0.5));
      east_velocity.push_back(random.gaussian(0.5));
    }
  }
};

void report_terms(benchmark::State& state, std::size_t terms) {
  state.counters["ns_per_term"] =
      benchmark::Counter(static_cast<double>(terms) * static_cast<double>(state.iterations()) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void vectorised(benchmark::State& state, csht::ClutterModel clutter, bool masked, double ahead = 80.0) {
  const auto table = noisy_table(clutter, clutter == csht::ClutterModel::point ? 0.1 : 0.5);
  csht::BeamMask mask;
  mask.clear(table);
  if (masked) csht::claim_beam(table, 50, 60.0, 0.5, mask);
  Cloud cloud(256, ahead);
  for (auto _ : state) {
    csht::add_log_ratio(table, &mask, {cloud.north, cloud.east, cloud.north_velocity, cloud.east_velocity},
                        -2.0, {}, cloud.sum);
    benchmark::DoNotOptimize(cloud.sum.data());
  }
  report_terms(state, 256);
}

void plain_loop(benchmark::State& state, csht::ClutterModel clutter) {
  const auto table = noisy_table(clutter, clutter == csht::ClutterModel::point ? 0.1 : 0.5);
  Cloud cloud(256);
  for (auto _ : state) {
    for (std::size_t i = 0; i < 256; ++i)
      cloud.sum[i] += csht::log_ratio(
          table, nullptr,
          {cloud.north[i] - 2.0 * cloud.north_velocity[i], cloud.east[i] - 2.0 * cloud.east_velocity[i]});
    benchmark::DoNotOptimize(cloud.sum.data());
  }
  report_terms(state, 256);
}

BENCHMARK_CAPTURE(vectorised, exclusive_beam, csht::ClutterModel::exclusive_beam, false);
BENCHMARK_CAPTURE(vectorised, exclusive_beam_masked, csht::ClutterModel::exclusive_beam, true);
BENCHMARK_CAPTURE(vectorised, exclusive_beam_at_the_end_of_the_range, csht::ClutterModel::exclusive_beam,
                  false, 145.0);
BENCHMARK_CAPTURE(vectorised, point_nine_returns, csht::ClutterModel::point, false);
BENCHMARK_CAPTURE(plain_loop, exclusive_beam, csht::ClutterModel::exclusive_beam);
BENCHMARK_CAPTURE(plain_loop, point_nine_returns, csht::ClutterModel::point);

}  // namespace

BENCHMARK_MAIN();
