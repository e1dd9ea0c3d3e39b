#include "tools/experiments/compare/compared_run.hpp"

#include <filesystem>
#include <map>
#include <set>

#include "core/input_error.hpp"
#include "tools/cli/recorded_chain.hpp"
#include "tools/cli/thread_time.hpp"
#include "tools/experiments/tracking/scored_run.hpp"

namespace lookout::tools {
namespace {

/// What a run leaves: the truth at each scan and the tracks of the accepted ones.
struct TrackedScans {
  std::vector<core::GroundTruth> truth;
  std::map<std::int64_t, std::vector<core::Track>> tracks;
  double spent_ms = 0.0;
};

/// Feeds a chain with all that reaches the vehicle, and times it.
class TimedChain {
 public:
  TimedChain(const tracking::ChainParams& params, TrackedScans& scans)
      : scans_(scans), chain_(params, [&scans](const tracking::PingResult& result) {
          scans.tracks[result.utime] = {result.tracks.begin(), result.tracks.end()};
        }) {}

  void add(const std::vector<core::VehicleState>& states) {
    timed([&] {
      for (const auto& state : states) chain_.add(state);
    });
  }
  void add(const core::SonarScan& scan) {
    timed([&] { chain_.add(scan); });
  }
  void finish() {
    timed([&] { chain_.finish(); });
  }

 private:
  void timed(const auto& work) {
    const double start_ms = thread_time_ms();
    work();
    scans_.spent_ms += thread_time_ms() - start_ms;
  }

  TrackedScans& scans_;
  tracking::TrackingChain chain_;
};

TrackedScans track_scene(const ComparedScene& scene, const Configuration& configuration, std::uint64_t seed,
                         int run) {
  sonar_sim::SonarSimulator simulator(scene.scene, seed, static_cast<std::uint64_t>(run),
                                      scene.view.platform);
  const sonar_sim::SonarPlan& sonar = scene.view.seen.sonar;
  TrackedScans scans;
  TimedChain chain(chain_params(configuration, run_seed(seed, run)), scans);
  while (const auto simulated = simulator.next()) {
    chain.add(simulated->states_before);
    if (simulated->scan.sensor_id == *sonar.sensor_id) {
      chain.add(simulated->scan);
      scans.truth.push_back(truth_in_view(*simulated, sonar));
    }
    chain.add(simulated->states_after);
  }
  chain.finish();
  return scans;
}

}  // namespace

std::vector<ComparedScene> compared_scenes(const std::vector<std::string>& files) {
  std::vector<ComparedScene> scenes;
  std::set<std::string> names;
  for (const auto& file : files) {
    const sonar_sim::Scene scene = sonar_sim::load_scene(file);
    for (const auto& view : sonar_views(scene)) {
      const std::string name = std::filesystem::path(file).stem().string() + view.folder;
      if (!names.insert(name).second)
        throw core::InputError(file + ": a scene called " + name +
                               " is there already, expected other file names");
      scenes.push_back({name, file, scene, view});
    }
  }
  return scenes;
}

Curve compared_run(const ComparedScene& scene, const Configuration& configuration,
                   const CurveScoreParams& params, std::uint64_t seed, int run) {
  TrackedScans scans = track_scene(scene, configuration, seed, run);
  std::vector<std::vector<core::Track>> tracks;
  for (const auto& truth : scans.truth) tracks.push_back(std::move(scans.tracks[truth.utime]));
  Curve curve = score_curve(scans.truth, tracks, params);
  if (!scans.truth.empty()) curve.time_ms = scans.spent_ms / static_cast<double>(scans.truth.size());
  return curve;
}

}  // namespace lookout::tools
