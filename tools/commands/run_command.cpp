#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/input_error.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/progress_bar.hpp"
#include "tools/cli/recorder.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/cli/sonar_views.hpp"
#include "tools/cli/tracked_run.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

void feed(RecordedChain& chain, const sonar_sim::SimulatedScan& simulated) {
  chain.add(simulated.scan);
}

void feed(RecordedImageChain& chain, const sonar_sim::SimulatedScan& simulated) {
  chain.add(*simulated.image);
}

template <class Chain>
TrackedRun run_through(Chain& chain, sonar_sim::SonarSimulator& simulator,
                       const sonar_sim::PlatformPlan& seen, const Configuration& configuration) {
  TrackedRun run;
  Recorder recorder(configuration.sensor);
  std::size_t done = 0;
  ProgressBar bar(static_cast<std::size_t>(num_scans(simulator.scene(), seen.sonar)));
  const auto add = [&](const std::vector<core::VehicleState>& states) {
    for (const auto& state : states) chain.add(state), recorder.add(state);
  };
  while (const auto simulated = simulator.next()) {
    add(simulated->states_before);
    if (simulated->scan.sensor_id == *seen.sonar.sensor_id) {
      feed(chain, *simulated);
      recorder.add(simulated->scan);
      recorder.add(truth_in_view(*simulated, seen.sonar));
      bar.show(++done);
    }
    add(simulated->states_after);
  }
  chain.finish();
  run.recording = recorder.finish();
  run.recording.params = configuration.sensor;
  run.output = chain.output();
  run.counts = chain.counts();
  return run;
}

TrackedRun run_sonar(const sonar_sim::Scene& scene, const SonarView& view, Configuration configuration,
                     const Options& options) {
  sonar_sim::SonarSimulator simulator(scene, options.seed, 0, view.platform);
  configuration.sensor = told_params(scene, view.seen, options);
  if (!tracks_images(configuration)) {
    RecordedChain chain(configuration, options.seed);
    return run_through(chain, simulator, view.seen, configuration);
  }
  if (!simulator.platform().image)
    throw core::InputError(options.inputs[0] + ": has no `image` part, which --estimator h_pmht needs");
  RecordedImageChain chain(configuration);
  return run_through(chain, simulator, view.seen, configuration);
}

}  // namespace

int run_command(const Options& options) {
  if (options.inputs.size() != 1) throw core::InputError("run: expected one SCENARIO.yaml");
  if (options.out.empty()) throw core::InputError("run: --out DIR is missing");
  const sonar_sim::Scene scene = sonar_sim::load_scene(options.inputs[0]);
  const Configuration configuration = load_configuration(options);
  refuse_idle_choices(options, configuration);
  make_scorer(options);  // a bad flag stops here, before the work
  // Of several sonars each has its own directory, for a recording holds one; images are the first sonar's.
  for (const SonarView& view : sonar_views(scene, tracks_images(configuration))) {
    const std::string directory = options.out + view.folder;
    make_directory(directory);
    const TrackedRun run = run_sonar(scene, view, configuration, options);
    core::write_recording(directory, run.recording);
    write_tracked_run(directory, run, configuration, options);
  }
  return 0;
}

}  // namespace lookout::tools
