// Time of one fusion by method, and its growth with nodes and targets. `update` is the whole front door:
// store, association, weights, management; `method` the weights alone, so that methods compare with the
// scalar mean.
#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "core/constant_velocity.hpp"
#include "core/frames.hpp"
#include "core/random.hpp"
#include "fusion/fusion.hpp"

namespace {

using namespace lookout;

constexpr double kPeriod = 0.5;    // [s]
constexpr double kSpacing = 40.0;  // Of the targets [m].

core::LocalEstimate estimate(int node, int target, int scan, core::Random& random) {
  core::LocalEstimate result;
  result.utime = core::microseconds(scan * kPeriod);
  result.sequence = scan;
  result.node_id = node + 1;
  result.p_earth_node = {-100.0, 60.0 * node};
  result.track_id = target + 1;
  const double north = kSpacing * (target % 10) + 1.5 * scan * kPeriod, east = kSpacing * (target / 10);
  result.state << north + random.gaussian(1.0), east + random.gaussian(1.0), 1.5, random.gaussian(0.1);
  result.covariance = Eigen::Matrix4d::Identity();
  return result;
}

fusion::FusionParams params_of(const std::string& method) {
  fusion::FusionParams params;
  params.method = method;
  return params;
}

void update(benchmark::State& state, const std::string& method) {
  const auto nodes = static_cast<int>(state.range(0)), targets = static_cast<int>(state.range(1));
  fusion::Fusion fusion(params_of(method));
  core::Random random(1);
  int scan = 0;
  const auto send_all = [&] {
    for (int node = 0; node < nodes; ++node) {
      for (int target = 0; target < targets; ++target) fusion.add(estimate(node, target, scan, random));
    }
  };
  const int warm_up = 30;
  for (; scan < warm_up; ++scan) {
    send_all();
    fusion.update(core::microseconds(scan * kPeriod));
  }
  for (auto _ : state) {
    state.PauseTiming();
    send_all();
    state.ResumeTiming();
    benchmark::DoNotOptimize(fusion.update(core::microseconds(scan * kPeriod)).data());
    ++scan;
  }
}

/// One set of groups, fused again and again.
void method_alone(benchmark::State& state, const std::string& method) {
  const auto nodes = static_cast<int>(state.range(0)), targets = static_cast<int>(state.range(1));
  core::Random random(1);
  std::vector<std::unique_ptr<fusion::LocalTrack>> tracks;
  std::vector<fusion::TrackGroup> groups;
  for (int target = 0; target < targets; ++target) {
    fusion::TrackGroup group;
    group.global_id = target;
    group.utime = core::microseconds(kPeriod);
    for (int node = 0; node < nodes; ++node) {
      tracks.push_back(std::make_unique<fusion::LocalTrack>(estimate(node, target, 0, random)));
      tracks.back()->append(estimate(node, target, 1, random));
      group.contributions.push_back({tracks.back().get(), tracks.back()->newest().state});
    }
    group.predicted = group.contributions.front().current;
    group.previous = core::moved(group.predicted, -kPeriod);
    groups.push_back(group);
  }
  const auto fusion = fusion::make_fusion_method(params_of(method));
  const int window = fusion::LearnedGeometryParams{}.window_updates;
  for (int k = 0; k < window; ++k) fusion->fuse(groups);
  for (auto _ : state) benchmark::DoNotOptimize(fusion->fuse(groups).data());
}

void register_all() {
  for (const std::string& method : fusion::fusion_method_names()) {
    benchmark::RegisterBenchmark(("method/" + method).c_str(), method_alone, method)
        ->Args({4, 4})
        ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark(("update/" + method).c_str(), update, method)
        ->Args({4, 4})
        ->Iterations(2000)
        ->Unit(benchmark::kMicrosecond);
  }
  for (const std::string method : {"mean", "sdf", "learned"}) {
    for (const auto& [nodes, targets] : {std::pair{8, 10}, {16, 30}, {32, 100}}) {
      benchmark::RegisterBenchmark(("method/" + method).c_str(), method_alone, method)
          ->Args({nodes, targets})
          ->Unit(benchmark::kMicrosecond);
      benchmark::RegisterBenchmark(("update/" + method).c_str(), update, method)
          ->Args({nodes, targets})
          ->Iterations(20)
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
