#include <filesystem>

#include "core/input_error.hpp"
#include "core/time_text.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/replay_log.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/cli/tracked_run.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

/// A recording's states and scans in the order of their times; of one time the state first.
TrackedRun replay_recording(const std::string& directory, Configuration& configuration, std::uint64_t seed) {
  TrackedRun run;
  run.recording = core::read_recording(directory, configuration.sensor);
  for (const auto& note : run.recording.notes) log_warning(note);
  std::vector<std::int64_t> times;
  for (const auto& scan : run.recording.scans) times.push_back(scan.utime);
  require_one_clock(times_of(run.recording.truth), times, directory + "/truth.csv");
  if (run.recording.params) configuration.sensor = *run.recording.params;
  RecordedChain chain(configuration, seed);
  auto state = run.recording.vehicle.begin();
  for (const auto& scan : run.recording.scans) {
    for (; state != run.recording.vehicle.end() && state->utime <= scan.utime; ++state) chain.add(*state);
    chain.add(scan);
  }
  for (; state != run.recording.vehicle.end(); ++state) chain.add(*state);
  chain.finish();
  run.output = chain.output();
  run.counts = chain.counts();
  return run;
}

void tell(const LogFigures& figures, const TrackedRun& run, const std::string& path) {
  log_info(path + ": " + std::to_string(figures.messages) + " messages");
  if (figures.damages > 0)
    log_warning(path + ": the log is damaged or cut off: " + std::to_string(figures.bytes_lost) +
                " bytes in " + std::to_string(figures.damages) + " place(s) could not be read");
  if (figures.bad_messages > 0)
    log_warning(path + ": " + std::to_string(figures.bad_messages) +
                " messages on our channels were damaged");
  if (figures.tracks.empty()) return;
  const std::string both = std::to_string(figures.tracks.size()) + " TRACKS in the log, " +
                           std::to_string(run.output.tracks.size()) + " now";
  if (const auto differs = first_difference(figures.tracks, run.output.tracks))
    log_warning(both + "; they differ from " + core::time_text(*differs) +
                " s on (another seed or configuration?)");
  else
    log_info(both + ", equal");
}

/// A log becomes a recording beside its tracks, and the tracks that it held.
TrackedRun replay_and_unpack_log(const std::string& path, const Configuration& configuration,
                                 const Options& options) {
  LogFigures figures;
  TrackedRun run = replay_log(path, options.channel_prefix, configuration, options.seed, figures);
  const std::string ping = tracks_images(configuration) ? "image" : "scan";
  if (figures.pings == 0)
    throw core::InputError(path + ": holds no " + ping + " on " + options.channel_prefix + "SONAR_" +
                           (ping == "image" ? "IMAGE" : "SCAN") +
                           "; expected an LCM log of the sonar (--channel-prefix names the vehicle)");
  tell(figures, run, path);
  core::write_recording(options.out, run.recording);
  if (!figures.tracks.empty()) core::write_tracks(options.out + "/logged_tracks.csv", figures.tracks);
  return run;
}

}  // namespace

int replay_command(const Options& options) {
  if (options.inputs.size() != 1)
    throw core::InputError("replay: expected one recording directory or LCM log");
  if (options.out.empty()) throw core::InputError("replay: --out DIR is missing");
  Configuration configuration = load_configuration(options);
  refuse_idle_choices(options, configuration);
  make_scorer(options);  // A bad flag stops here, before the work.
  std::string input = options.inputs[0];
  if (input.starts_with("file://")) input = input.substr(7, input.find('?') - 7);
  const bool is_directory = std::filesystem::is_directory(input);
  if (is_directory && !options.channel_prefix.empty())
    throw core::InputError(
        "--channel-prefix: has no effect on a recording directory, expected an LCM log or none");
  if (is_directory && tracks_images(configuration))
    throw core::InputError("--estimator: h_pmht needs raw images, which " + input +
                           " does not hold; expected an LCM log with SONAR_IMAGE");
  if (is_directory && std::filesystem::exists(options.out) && std::filesystem::equivalent(input, options.out))
    throw core::InputError("--out: is the recording itself, expected another directory");
  make_directory(options.out);
  const TrackedRun run = is_directory ? replay_recording(input, configuration, options.seed)
                                      : replay_and_unpack_log(input, configuration, options);
  write_tracked_run(options.out, run, configuration, options);
  return 0;
}

}  // namespace lookout::tools
