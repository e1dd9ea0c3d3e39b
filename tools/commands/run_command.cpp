#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/field_of_view.hpp"
#include "core/input_error.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/images/image_keeper.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/progress_bar.hpp"
#include "tools/cli/recorder.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/cli/sonar_views.hpp"
#include "tools/cli/tracked_run.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

// Half-power extents of a point's echo: of a Gaussian pulse in sigmas, 2 sqrt(ln 2); of a beam in first
// nulls, where sinc(u)^2 and, with a Hann taper, (sinc(2u) / (1 - 4u^2))^2 are one half.
constexpr double kPulseLength = 1.6651, kLineWidth = 0.8859, kTaperedWidth = 0.7203;

void feed(RecordedChain& chain, const sonar_sim::SimulatedScan& simulated) {
  chain.add(simulated.scan);
}

void feed(RecordedImageChain& chain, const sonar_sim::SimulatedScan& simulated) {
  chain.add(*simulated.image);
}

void feed(RecordedDetectionChain& chain, const sonar_sim::SimulatedScan& simulated) {
  chain.add(*simulated.image);
}

/// Pulse and beam as the scene has them: what an instrument's data sheet says.
void tell_echo(const sonar_sim::ImagePlan& plan, tracking::EchoParams& echo) {
  if (!echo.pulse_length) echo.pulse_length = kPulseLength * plan.pulse_sigma;
  if (!echo.beam_width) echo.beam_width = (plan.tapered ? kTaperedWidth : kLineWidth) * plan.beam_null;
}

/// @param recorder of the scans: the sonar's own unless the chain makes them of images.
template <class Chain>
TrackedRun run_through(Chain& chain, sonar_sim::SonarSimulator& simulator,
                       const sonar_sim::PlatformPlan& seen, const Configuration& configuration,
                       const std::string& directory, Recorder& recorder) {
  TrackedRun run;
  ImageKeeper images(directory);
  std::size_t done = 0;
  ProgressBar bar(static_cast<std::size_t>(num_scans(simulator.scene(), seen.sonar)));
  const auto add = [&](const std::vector<core::VehicleState>& states) {
    for (const auto& state : states) chain.add(state), recorder.add(state);
  };
  while (const auto simulated = simulator.next()) {
    add(simulated->states_before);
    if (simulated->scan.sensor_id == *seen.sonar.sensor_id) {
      if (simulated->image) images.add(*simulated->image);
      feed(chain, *simulated);
      if (!configuration.detects) recorder.add(simulated->scan);
      recorder.add(truth_in_view(*simulated, seen.sonar));
      bar.show(++done);
    }
    add(simulated->states_after);
  }
  chain.finish();
  run.recording = recorder.finish();
  run.recording.params = configuration.sensor;
  run.recording.has_images = images.close();
  run.output = chain.output();
  run.counts = chain.counts();
  return run;
}

/// The images through detection, whose scans are the recording's.
TrackedRun run_detected(sonar_sim::SonarSimulator& simulator, const sonar_sim::PlatformPlan& seen,
                        const std::string& directory, Configuration configuration, const Options& options) {
  if (!options.unknown_sensor) tell_echo(*simulator.platform().image, configuration.detection.echo);
  Recorder scans(configuration.sensor);
  RecordedDetectionChain chain(configuration, options.seed,
                               [&scans](const core::SonarScan& scan) { scans.add(scan); });
  TrackedRun run = run_through(chain, simulator, seen, configuration, directory, scans);
  if (!run.recording.scans.empty())
    run.recording.params = core::with_geometry_of(run.recording.scans.front(), chain.sensor());
  return run;
}

/// @param directory that its images are written to.
TrackedRun run_sonar(const sonar_sim::Scene& scene, const SonarView& view, const std::string& directory,
                     Configuration configuration, const Options& options) {
  sonar_sim::SonarSimulator simulator(scene, options.seed, 0, view.platform);
  const core::SonarParams configured = configuration.sensor;
  configuration.sensor = told_params(scene, view.seen, options);
  if (configuration.detects) configuration.sensor = params_of_images(configuration.sensor, configured);
  Recorder recorder(configuration.sensor);
  if (!takes_images(configuration)) {
    RecordedChain chain(configuration, options.seed);
    return run_through(chain, simulator, view.seen, configuration, directory, recorder);
  }
  if (!simulator.platform().image)
    throw core::InputError(options.inputs[0] + ": has no `image` part, which " +
                           (configuration.detects ? "--input image" : "--estimator h_pmht") + " needs");
  if (configuration.detects) return run_detected(simulator, view.seen, directory, configuration, options);
  RecordedImageChain chain(configuration);
  return run_through(chain, simulator, view.seen, configuration, directory, recorder);
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
  for (const SonarView& view : sonar_views(scene, takes_images(configuration))) {
    const std::string directory = options.out + view.folder;
    make_directory(directory);
    const TrackedRun run = run_sonar(scene, view, directory, configuration, options);
    core::write_recording(directory, run.recording);
    write_tracked_run(directory, run, configuration, options);
  }
  return 0;
}

}  // namespace lookout::tools
