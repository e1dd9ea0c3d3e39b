#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "core/input_error.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/commands/commands.hpp"
#include "tools/log.hpp"
#include "tools/paths.hpp"
#include "tools/progress_bar.hpp"
#include "tools/scoring.hpp"
#include "tools/tracking_chain.hpp"
#include "tools/vote_matrices.hpp"

namespace lookout::tools {
namespace {

/// What one vehicle of the scene recorded and tracked.
struct Run {
  core::Recording recording;
  ChainOutput output;
  tracking::IntakeCounts counts;
};

/// Keeps the reports that the chain believed, as a recording holds them: each later than all before it.
void keep_in_order(std::vector<core::VehicleState>& vehicle) {
  std::vector<core::VehicleState> kept;
  for (const auto& state : vehicle) {
    if (kept.empty() || state.utime > kept.back().utime) kept.push_back(state);
  }
  vehicle = std::move(kept);
}

/// What the tracker is told: the configuration, with the geometry that the scans carry; with --known-sensor
/// the scene's accuracy and probabilities too.
core::SonarParams told_params(const sonar_sim::Scene& scene, const sonar_sim::PlatformPlan& platform,
                              const Configuration& configuration, bool known_sensor) {
  if (known_sensor) return sonar_sim::known_params(scene, platform);
  const core::SonarParams& plan = platform.sonar.params;
  core::SonarParams told = configuration.sensor;
  told.num_beams = plan.num_beams;
  told.first_bearing = plan.first_bearing;
  told.bearing_step = plan.bearing_step;
  told.max_range = plan.max_range;
  told.T_body_sonar = plan.T_body_sonar;
  told.scan_period = plan.scan_period;
  return told;
}

Run run_platform(const sonar_sim::Scene& scene, std::size_t index, Configuration configuration,
                 const Options& options) {
  sonar_sim::SonarSimulator simulator(scene, options.seed, 0, index);
  configuration.sensor = told_params(scene, simulator.platform(), configuration, options.known_sensor);
  RecordedChain chain(configuration, options.seed);
  Run run;
  run.recording.params = configuration.sensor;
  ProgressBar bar(static_cast<std::size_t>(num_scans(scene, simulator.platform())));
  while (const auto simulated = simulator.next()) {
    for (const auto& state : simulated->states_before) chain.add(state);
    chain.add(simulated->scan);
    for (const auto& state : simulated->states_after) chain.add(state);
    auto& vehicle = run.recording.vehicle;
    vehicle.insert(vehicle.end(), simulated->states_before.begin(), simulated->states_before.end());
    vehicle.insert(vehicle.end(), simulated->states_after.begin(), simulated->states_after.end());
    run.recording.scans.push_back(simulated->scan);
    run.recording.truth.push_back(simulated->truth);
    bar.show(run.recording.scans.size());
  }
  keep_in_order(run.recording.vehicle);
  chain.finish();
  run.output = chain.output();
  run.counts = chain.counts();
  return run;
}

/// ospa.csv, a row a scan that was tracked.
void write_ospa(const std::string& path, const Run& run, tracking::Scorer& scorer) {
  core::CsvWriter csv(path, "time_s,total,localization,cardinality,num_truth,num_tracks");
  auto truth = run.recording.truth.begin();
  for (const auto& list : run.output.tracks) {
    while (truth->utime < list.utime) ++truth;
    const tracking::OspaResult& ospa = scorer.add(*truth, list.tracks).position;
    csv.number(core::seconds(list.utime))
        .number(ospa.total)
        .number(ospa.localization)
        .number(ospa.cardinality);
    csv.integer(ospa.num_truth).integer(ospa.num_tracks).end_row();
  }
  csv.close();
}

void write_summary(const std::string& path, const Run& run, const Configuration& configuration,
                   const tracking::Scorer& scorer, const Options& options) {
  const tracking::OspaResult mean = scorer.mean().position;
  const nlohmann::ordered_json root{
      {"scenario", options.inputs[0]},
      {"seed", options.seed},
      {"tracker", configuration.tracker.name},
      {"estimator", configuration.estimator.name},
      {"scans", run.recording.scans.size()},
      {"tracked_scans", run.output.tracks.size()},
      {"rejected_scans", run.counts.rejected()},
      {"truth", options.truth},
      {"cutoff", options.cutoff},
      {"order", options.order},
      {"ospa",
       {{"total", mean.total}, {"localization", mean.localization}, {"cardinality", mean.cardinality}}}};
  std::ofstream file(path);
  file << root.dump(1) << "\n";
  if (!file) throw std::runtime_error(path + ": could not be written");
}

void write_run(const std::string& directory, const Run& run, const Configuration& configuration,
               const Options& options) {
  core::write_recording(directory, run.recording);
  core::write_tracks(directory + "/tracks.csv", run.output.tracks);
  core::write_elements(directory + "/elements.csv", run.output.elements);
  if (options.votes_at)
    write_vote_matrices(run.recording, *run.recording.params, core::microseconds(*options.votes_at),
                        directory);
  tracking::Scorer scorer = make_scorer(options);
  write_ospa(directory + "/ospa.csv", run, scorer);
  write_summary(directory + "/summary.json", run, configuration, scorer, options);
  log_info(directory + ": " + describe(run.counts) + ", " + describe(scorer.mean().position) + ", truth " +
           options.truth);
}

}  // namespace

int run_command(const Options& options) {
  if (options.inputs.size() != 1) throw core::InputError("run: expected one SCENARIO.yaml");
  if (options.out.empty()) throw core::InputError("run: --out DIR is missing");
  const sonar_sim::Scene scene = sonar_sim::load_scene(options.inputs[0]);
  const Configuration configuration = load_configuration(options);
  make_scorer(options);  // a bad flag stops here, before the work
  for (std::size_t index = 0; index < scene.platforms.size(); ++index) {
    const bool alone = scene.platforms.size() == 1;
    const std::string directory =
        alone ? options.out : options.out + "/node" + std::to_string(scene.platforms[index].node_id);
    make_directory(directory);
    write_run(directory, run_platform(scene, index, configuration, options), configuration, options);
  }
  return 0;
}

}  // namespace lookout::tools
