#include "core/input_error.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/progress_bar.hpp"
#include "tools/cli/recorder.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/cli/tracked_run.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

/// What the tracker is told: the scene's figures and over them what the configuration says; with
/// --unknown-sensor the configuration alone. The geometry is always that of the scans.
core::SonarParams told_params(const sonar_sim::Scene& scene, const sonar_sim::PlatformPlan& platform,
                              const Options& options) {
  const core::SonarParams known =
      options.unknown_sensor ? core::SonarParams{} : sonar_sim::known_params(scene, platform);
  const core::SonarParams& plan = platform.sonar.params;
  core::SonarParams told = load_configuration(options, known).sensor;
  told.num_beams = plan.num_beams;
  told.first_bearing = plan.first_bearing;
  told.bearing_step = plan.bearing_step;
  told.max_range = plan.max_range;
  told.T_body_sonar = plan.T_body_sonar;
  told.scan_period = plan.scan_period;
  return told;
}

void feed(RecordedChain& chain, const sonar_sim::SimulatedScan& simulated) {
  chain.add(simulated.scan);
}

void feed(RecordedImageChain& chain, const sonar_sim::SimulatedScan& simulated) {
  chain.add(*simulated.image);
}

template <class Chain>
TrackedRun run_through(Chain& chain, sonar_sim::SonarSimulator& simulator,
                       const Configuration& configuration) {
  const sonar_sim::Scene& scene = simulator.scene();
  TrackedRun run;
  Recorder recorder(configuration.sensor);
  std::size_t done = 0;
  ProgressBar bar(static_cast<std::size_t>(num_scans(scene, simulator.platform())));
  while (const auto simulated = simulator.next()) {
    for (const auto& state : simulated->states_before) chain.add(state), recorder.add(state);
    feed(chain, *simulated);
    recorder.add(simulated->scan);
    for (const auto& state : simulated->states_after) chain.add(state), recorder.add(state);
    recorder.add(simulated->truth);
    bar.show(++done);
  }
  chain.finish();
  run.recording = recorder.finish();
  run.recording.params = configuration.sensor;
  run.output = chain.output();
  run.counts = chain.counts();
  return run;
}

TrackedRun run_platform(const sonar_sim::Scene& scene, std::size_t index, Configuration configuration,
                        const Options& options) {
  sonar_sim::SonarSimulator simulator(scene, options.seed, 0, index);
  configuration.sensor = told_params(scene, simulator.platform(), options);
  if (!tracks_images(configuration)) {
    RecordedChain chain(configuration, options.seed);
    return run_through(chain, simulator, configuration);
  }
  if (!simulator.platform().image)
    throw core::InputError(options.inputs[0] + ": has no `image` part, which --estimator h_pmht needs");
  RecordedImageChain chain(configuration);
  return run_through(chain, simulator, configuration);
}

}  // namespace

int run_command(const Options& options) {
  if (options.inputs.size() != 1) throw core::InputError("run: expected one SCENARIO.yaml");
  if (options.out.empty()) throw core::InputError("run: --out DIR is missing");
  const sonar_sim::Scene scene = sonar_sim::load_scene(options.inputs[0]);
  const Configuration configuration = load_configuration(options);
  refuse_idle_choices(options, configuration);
  make_scorer(options);  // a bad flag stops here, before the work
  for (std::size_t index = 0; index < scene.platforms.size(); ++index) {
    const bool alone = scene.platforms.size() == 1;
    const std::string directory =
        alone ? options.out : options.out + "/node" + std::to_string(scene.platforms[index].node_id);
    make_directory(directory);
    const TrackedRun run = run_platform(scene, index, configuration, options);
    core::write_recording(directory, run.recording);
    write_tracked_run(directory, run, configuration, options);
  }
  return 0;
}

}  // namespace lookout::tools
