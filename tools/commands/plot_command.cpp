#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

#include "core/files/csv.hpp"
#include "core/files/image_recording.hpp"
#include "core/files/recording.hpp"
#include "core/input_error.hpp"
#include "tools/cli/log.hpp"
#include "tools/cli/logs/log_tables.hpp"
#include "tools/cli/paths.hpp"
#include "tools/cli/scoring.hpp"
#include "tools/cli/temporary_directory.hpp"
#include "tools/commands/commands.hpp"

namespace lookout::tools {
namespace {

namespace fs = std::filesystem;

void write_scores(const std::string& path, tracking::Scorer scorer,
                  const std::vector<core::GroundTruth>& truth, const std::vector<core::TrackList>& tracks) {
  constexpr std::int64_t kSameTime = 1;  // [us]
  core::CsvWriter csv(path,
                      "time_s,total,localization,cardinality,num_truth,num_tracks,gospa,gospa_localization,"
                      "gospa_missed,gospa_false");
  for (const auto& targets : truth) {
    const auto list = std::lower_bound(
        tracks.begin(), tracks.end(), targets.utime - kSameTime,
        [](const core::TrackList& tracks_then, std::int64_t time) { return tracks_then.utime < time; });
    const bool found = list != tracks.end() && list->utime <= targets.utime + kSameTime;
    const auto& score = scorer.add(targets, found ? list->tracks : std::vector<core::Track>());
    csv.number(core::seconds(targets.utime)).number(score.position.total).number(score.position.localization);
    csv.number(score.position.cardinality).integer(score.position.num_truth);
    csv.integer(score.position.num_tracks).number(score.gospa.total).number(score.gospa.localization);
    csv.number(score.gospa.missed).number(score.gospa.false_tracks).end_row();
  }
  csv.close();
}

/// Scores truth.csv and tracks.csv where both are there. What cannot be read is told and not scored: the
/// drawing shows what there is.
void score(const std::string& directory, const Options& options, const std::string& path) {
  tracking::Scorer scorer = make_scorer(options);
  const std::string truth = directory + "/truth.csv", tracks = directory + "/tracks.csv";
  if (!fs::exists(truth) || !fs::exists(tracks)) return;
  try {
    write_scores(path, std::move(scorer), core::read_truth(truth), core::read_tracks(tracks));
  } catch (const core::InputError& error) {
    log_warning(std::string("plot: not scored: ") + error.what());
  }
}

/// The files to write: one of the ending asked for, or PNG and PDF beside the input, with --animate a GIF.
std::vector<std::string> outputs(const Options& options, const fs::path& input, bool is_directory) {
  const std::string stem = is_directory ? (input / "lookout").string() : input.string();
  std::vector<std::string> files{stem + ".png", stem + ".pdf"};
  if (!options.out.empty()) {
    const std::string ending = fs::path(options.out).extension().string();
    if (ending != ".png" && ending != ".pdf" && ending != ".gif")
      throw core::InputError("--out: got `" + options.out +
                             "`, expected a name that ends in .png, .pdf or .gif");
    const fs::path folder = fs::absolute(options.out).parent_path();
    if (!fs::is_directory(folder))
      throw core::InputError("--out: " + folder.string() +
                             " is not there, expected a name in a directory that is");
    files = {options.out};
  }
  if (options.animate && fs::path(files.front()).extension() != ".gif")
    files.push_back(fs::path(files.front()).replace_extension(".gif").string());
  return files;
}

void require_something_to_draw(const std::string& directory) {
  for (const char* name : {"scans.csv", "vehicle.csv", "truth.csv", "tracks.csv", "ospa.csv"}) {
    if (fs::is_regular_file(fs::path(directory) / name)) return;
  }
  throw core::InputError(
      directory +
      ": nothing to draw; expected images.csv, scans.csv, vehicle.csv, truth.csv, tracks.csv or ospa.csv");
}

/// A recording of images without anything that was made of them.
bool shows_images_alone(const std::string& directory) {
  return core::holds_images(directory) && !fs::exists(directory + "/scans.csv") &&
         !fs::exists(directory + "/tracks.csv");
}

bool is_table(const std::string& input) {
  std::string ending = fs::path(input).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return std::tolower(letter); });
  return ending == ".csv";
}

void require_input(const std::string& input, const Options& options) {
  if (!fs::is_directory(input) && !fs::is_regular_file(input))
    throw core::InputError(input + (fs::exists(input) ? ": is a pipe or a device" : ": is not there") +
                           "; expected a directory of recordings or tracks, a CSV file, or an LCM log");
  if (!options.channel_prefix.empty() && (fs::is_directory(input) || is_table(input)))
    throw core::InputError("--channel-prefix: chooses channels of an LCM log, which " + input + " is not");
}

/// Draws with a script of the tools directory. @return the exit status.
int draw(const std::string& script, std::vector<std::string> arguments,
         const std::vector<std::string>& files) {
  arguments.insert(arguments.end(), files.begin(), files.end());
  if (const int status = run_plot_script(script, arguments); status != 0) return status;
  for (const auto& file : files) log_info("plot: wrote " + file);
  return 0;
}

}  // namespace

int plot_command(const Options& options) {
  const std::string input = options.inputs.at(0);
  require_input(input, options);
  const bool is_directory = fs::is_directory(input);
  const bool images_alone = is_directory && shows_images_alone(input);
  if (is_directory && !images_alone) require_something_to_draw(input);
  const auto files = outputs(options, fs::path(input), is_directory);
  const std::string title = fs::path(input).lexically_normal().string();
  if (images_alone) return draw("plot_images.py", {input}, files);
  if (!is_directory && is_table(input)) return draw("plot_run.py", {input, "--title", title}, files);
  const TemporaryDirectory scratch("lookout_plot_");
  const std::string directory = is_directory ? input : scratch.path();
  if (!is_directory)
    for (const auto& line : write_log_tables(input, options.channel_prefix, directory))
      log_warning("plot: " + line);
  score(directory, options, scratch.file("scores.csv"));
  return draw("plot_run.py", {directory, "--scores", scratch.file("scores.csv"), "--title", title}, files);
}

}  // namespace lookout::tools
