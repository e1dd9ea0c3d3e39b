#include <filesystem>

#include "core/files/time_text.hpp"
#include "core/input_error.hpp"
#include "tools/cli/images/image_feed.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/logs/replay_log.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/scan_feed.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/cli/tracked_run.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

TrackedRun replay_recording(const std::string& directory, Configuration& configuration, std::uint64_t seed) {
  TrackedRun run;
  run.recording = core::read_recording(directory, configuration.sensor);
  for (const auto& note : run.recording.notes) log_warning(note);
  if (run.recording.new_clocks.empty()) {
    std::vector<std::int64_t> times;
    for (const auto& scan : run.recording.scans) times.push_back(scan.utime);
    require_one_clock(times_of(run.recording.truth), times, directory + "/truth.csv");
  }
  if (run.recording.params) configuration.sensor = *run.recording.params;
  RecordedChain chain(configuration, seed);
  feed_scans(chain, run.recording);
  chain.finish();
  run.output = chain.output();
  run.counts = chain.counts();
  return run;
}

template <class Chain>
void through(Chain& chain, const core::ImageReader& images, TrackedRun& run) {
  feed_images(chain, run.recording, images);
  chain.finish();
  run.output = chain.output();
  run.counts = chain.counts();
}

/// The images of a recording through the tracker of images, or through detection and a tracker of returns.
TrackedRun replay_images(const std::string& directory, Configuration& configuration, std::uint64_t seed) {
  TrackedRun run;
  run.recording = core::read_recording(directory, configuration.sensor);
  const core::ImageReader images(directory);
  for (const auto& note : run.recording.notes) log_warning(note);
  std::vector<std::int64_t> times;
  for (std::size_t i = 0; i < images.size(); ++i) times.push_back(images.utime(i));
  if (run.recording.new_clocks.empty())
    require_one_clock(times_of(run.recording.truth), times, directory + "/truth.csv");
  if (configuration.detects) {
    if (run.recording.params)
      configuration.sensor = params_of_images(*run.recording.params, configuration.sensor);
    RecordedDetectionChain chain(configuration, seed, {});
    through(chain, images, run);
    return run;
  }
  if (run.recording.params) configuration.sensor = *run.recording.params;
  RecordedImageChain chain(configuration);
  through(chain, images, run);
  return run;
}

/// @throws core::InputError where the directory does not hold the pings that the configuration tracks.
void require_pings(const std::string& directory, const Configuration& configuration) {
  const bool images = core::holds_images(directory);
  if (takes_images(configuration) && !images)
    throw core::InputError(directory + ": holds no images.csv, which " +
                           (configuration.detects ? "--input image" : "--estimator h_pmht") +
                           " needs; expected a recording " + "of images, or an LCM log with SONAR_IMAGE");
  if (!takes_images(configuration) && images && !std::filesystem::exists(directory + "/scans.csv"))
    throw core::InputError(directory +
                           ": holds images and no scans.csv; expected --input image, or --estimator h_pmht");
}

/// What a person should know of a log: what it holds, and every message that was not used.
void tell(const LogFigures& figures, const TrackedRun& run, const std::string& path) {
  const LogSurvey& survey = figures.survey;
  log_info(path + ": " + std::to_string(survey.messages) + " messages: " + survey.names());
  for (const auto& note : notes_of(figures, run.recording)) log_warning(path + ": " + note);
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
TrackedRun replay_and_unpack_log(const std::vector<std::string>& files, const Configuration& configuration,
                                 const Options& options) {
  LogFigures figures;
  TrackedRun run =
      replay_log(files, options.channel_prefix, configuration, options.seed, figures, options.out);
  tell(figures, run, files.size() == 1 ? files.front() : files.front() + " to " + files.back());
  core::write_recording(options.out, run.recording);
  if (!figures.tracks.empty()) core::write_tracks(options.out + "/logged_tracks.csv", figures.tracks);
  return run;
}

/// The path in an LCM address `file://PATH?...`, or the path itself.
std::string path_of(const std::string& input) {
  return input.starts_with("file://") ? input.substr(7, input.find('?') - 7) : input;
}

/// Scores need one clock: the truth of several stays in the recording alone.
void leave_out_truth_of_several_clocks(TrackedRun& run) {
  if (run.recording.new_clocks.empty() || run.recording.truth.empty()) return;
  run.recording.truth.clear();
  log_warning("several clocks: the tracks are not scored");
}

}  // namespace

int replay_command(const Options& options) {
  if (options.inputs.empty()) throw core::InputError("replay: expected one recording directory, or LCM logs");
  if (options.out.empty()) throw core::InputError("replay: --out DIR is missing");
  Configuration configuration = load_configuration(options);
  refuse_idle_choices(options, configuration);
  make_scorer(options);  // A bad flag stops here, before the work.
  std::vector<std::string> inputs;
  for (const auto& input : options.inputs) inputs.push_back(path_of(input));
  const std::string& input = inputs.front();
  const bool is_directory = std::filesystem::is_directory(input);
  if (is_directory && !options.channel_prefix.empty())
    throw core::InputError(
        "--channel-prefix: has no effect on a recording directory, expected an LCM log or none");
  if (is_directory && inputs.size() > 1)
    throw core::InputError("replay: expected one recording directory, or LCM logs; got " +
                           std::to_string(inputs.size()) + " inputs");
  if (is_directory) require_pings(input, configuration);
  if (is_directory && std::filesystem::exists(options.out) && std::filesystem::equivalent(input, options.out))
    throw core::InputError("--out: is the recording itself, expected another directory");
  make_directory(options.out);
  TrackedRun run = !is_directory ? replay_and_unpack_log(log_files(inputs), configuration, options)
                   : takes_images(configuration) ? replay_images(input, configuration, options.seed)
                                                 : replay_recording(input, configuration, options.seed);
  leave_out_truth_of_several_clocks(run);
  write_tracked_run(options.out, run, configuration, options);
  return 0;
}

}  // namespace lookout::tools
