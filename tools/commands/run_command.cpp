#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/field_of_view.hpp"
#include "core/input_error.hpp"
#include "sonar_sim/sonar_simulator.hpp"
#include "tools/cli/image_keeper.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/progress_bar.hpp"
#include "tools/cli/recorder.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/cli/tracked_run.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

// Half-power extents of a point's echo: of a Gaussian pulse in sigmas, 2 sqrt(ln 2); of a beam in first
// nulls, where sinc(u)^2 and, with a Hann taper, (sinc(2u) / (1 - 4u^2))^2 are one half.
constexpr double kPulseLength = 1.6651, kLineWidth = 0.8859, kTaperedWidth = 0.7203;

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

/// The truth as this sonar alone sees it.
core::GroundTruth truth_in_view(const sonar_sim::SimulatedScan& simulated,
                                const sonar_sim::SonarPlan& sonar) {
  const core::SonarParams params = core::with_geometry_of(simulated.scan, sonar.params);
  core::GroundTruth truth = simulated.truth;
  for (auto& target : truth.targets)
    target.visible = core::observe(params, simulated.T_earth_sonar, target.position).visible();
  return truth;
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

/// @param seen the vehicle with one of its sonars alone.
/// @param directory that its images are written to.
TrackedRun run_sonar(const sonar_sim::Scene& scene, std::size_t index, const sonar_sim::PlatformPlan& seen,
                     const std::string& directory, const Options& options) {
  Configuration configuration = load_configuration(options);
  sonar_sim::SonarSimulator simulator(scene, options.seed, 0, index);
  const core::SonarParams configured = configuration.sensor;
  configuration.sensor = told_params(scene, seen, options);
  if (configuration.detects) configuration.sensor = params_of_images(configuration.sensor, configured);
  Recorder recorder(configuration.sensor);
  if (!takes_images(configuration)) {
    RecordedChain chain(configuration, options.seed);
    return run_through(chain, simulator, seen, configuration, directory, recorder);
  }
  if (!simulator.platform().image)
    throw core::InputError(options.inputs[0] + ": has no `image` part, which " +
                           (configuration.detects ? "--input image" : "--estimator h_pmht") + " needs");
  if (configuration.detects) return run_detected(simulator, seen, directory, configuration, options);
  RecordedImageChain chain(configuration);
  return run_through(chain, simulator, seen, configuration, directory, recorder);
}

/// Runs and writes each sonar of a vehicle; of several, each its own directory, for a recording holds one.
void run_platform(const sonar_sim::Scene& scene, std::size_t index, const std::string& directory,
                  const Configuration& configuration, const Options& options) {
  const sonar_sim::PlatformPlan& platform = scene.platforms[index];
  const auto sonars = all_sonars(platform);
  for (std::size_t i = 0; i < sonars.size(); ++i) {
    if (i > 0 && takes_images(configuration)) break;  // Images are the first sonar's.
    sonar_sim::PlatformPlan seen = platform;
    seen.sonar = *sonars[i];
    seen.further_sonars.clear();
    seen.sonar.sensor_id = sonars[i]->sensor_id.value_or(platform.node_id + static_cast<std::int32_t>(i));
    const std::string own =
        sonars.size() == 1 ? directory : directory + "/sonar" + std::to_string(*seen.sonar.sensor_id);
    make_directory(own);
    const TrackedRun run = run_sonar(scene, index, seen, own, options);
    core::write_recording(own, run.recording);
    write_tracked_run(own, run, configuration, options);
  }
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
    run_platform(scene, index, directory, configuration, options);
  }
  return 0;
}

}  // namespace lookout::tools
