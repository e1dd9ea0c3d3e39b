// Time of every initiator: at 10 clutter plots a scan on the scene of [Fan2018], and its growth with the
// clutter.
#include <benchmark/benchmark.h>

#include "tools/experiments/initiation/initiation_scene.hpp"
#include "tracking/initiation/initiator_registry.hpp"

namespace lookout::tools {
namespace {

void run_method(benchmark::State& state, const InitiationScene& scene, const std::string& name,
                const tracking::InitiatorConfig& config) {
  const auto method = tracking::make_initiator(name, config);
  const tracking::PlotWindow window = scene.window();
  for (auto _ : state) benchmark::DoNotOptimize(method->start(window).tracks.size());
  state.SetComplexityN(state.range(0));
}

/// Situation IV at the consistent noise, seven scans.
void fan(benchmark::State& state, const std::string& name, const std::string& variant) {
  FanSceneParams params;
  params.clutter_per_scan = static_cast<double>(state.range(0));
  core::Random random(1, core::RandomStream::experiment);
  tracking::InitiatorConfig config;
  config.position_sigma = plot_sigma(params);
  config.variant = variant;
  if (name == "vct") config.window_scans = 7;
  if (name == "vct") config.min_plots = 6;
  run_method(state, fan_scene(params, random), name, config);
}

/// Four scans of [Zeng2023].
void zeng(benchmark::State& state, const std::string& name) {
  ZengSceneParams params;
  params.clutter_per_scan = static_cast<double>(state.range(0));
  core::Random random(1, core::RandomStream::experiment);
  tracking::InitiatorConfig config;
  config.min_speed = 333.0;
  config.max_speed = 750.0;
  run_method(state, zeng_scene(params, random), name, config);
}

#define FAN(name, variant) \
  BENCHMARK_CAPTURE(fan, name##variant, #name, #variant)->Arg(5)->Arg(10)->Arg(20)->Arg(50)->Complexity()
FAN(ht, );
FAN(mht_ti, );
FAN(iht_ti, );
FAN(nht_ti, spread);
FAN(nht_ti, cell);
FAN(nht_plus, );
FAN(vct, );

#define ZENG(name) BENCHMARK_CAPTURE(zeng, name, #name)->RangeMultiplier(2)->Range(30, 960)->Complexity()
ZENG(ag_fht);
ZENG(modified_logic);
ZENG(modified_ht);
ZENG(sequence_ht);
ZENG(fpht);
ZENG(vct);

}  // namespace
}  // namespace lookout::tools
