#include "tools/cli/logs/replay_log.hpp"

#include <algorithm>
#include <functional>

#include "core/field_of_view.hpp"
#include "core/input_error.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/inbox.hpp"
#include "lcmtypes/log_reader.hpp"
#include "tools/cli/images/image_keeper.hpp"
#include "tools/cli/recorder.hpp"

namespace lookout::tools {
namespace {

bool same(const core::Track& a, const core::Track& b) {
  return a.id == b.id && a.status == b.status && a.state == b.state && a.existence == b.existence;
}

bool same(const core::TrackList& a, const core::TrackList& b) {
  return a.utime == b.utime && a.tracks.size() == b.tracks.size() &&
         std::equal(a.tracks.begin(), a.tracks.end(), b.tracks.begin(),
                    [](const core::Track& x, const core::Track& y) { return same(x, y); });
}

/// Where the messages of a log go: the chain that tracks, and the recorder beside it.
template <class Chain>
class LogReplay {
 public:
  LogReplay(const lcmtypes::Channels& channels, Chain& chain, const core::SonarParams& sensor,
            LogFigures& figures, const std::string& images_out)
      : channels_(channels), chain_(chain), recorder_(sensor), images_(images_out), figures_(figures) {
    figures_.is_fixed = !figures_.survey.channels.contains(channels_.vehicle_state());
    inbox_.on<vehicle_state_t>(channels_.vehicle_state(),
                               [this](const core::VehicleState& state) { add(state); });
    inbox_.on<ground_truth_t>(channels_.ground_truth(),
                              [this](core::GroundTruth truth) { recorder_.add(std::move(truth)); });
    inbox_.on<track_list_t>(channels_.tracks(), [this](lcmtypes::KeyedTracks tracks) {
      figures_.tracks.push_back({tracks.key.utime, std::move(tracks.tracks)});
    });
  }

  /// Scans are kept, and tracked where `Chain` does that.
  void take_scans(bool are_tracked) {
    inbox_.on<sonar_scan_t>(channels_.sonar_scan(), [this, are_tracked](const core::SonarScan& scan) {
      if (are_tracked) note_ping(scan.utime);
      if (figures_.is_fixed) add(core::VehicleState{scan.utime, {}, {0.0, 0.0}});
      if constexpr (requires { chain_.add(scan); }) chain_.add(scan);
      recorder_.add(scan);
    });
  }
  /// Images are kept, and tracked where `Chain` does that.
  void take_images(bool are_tracked) {
    inbox_.on<sonar_image_t>(channels_.sonar_image(), [this, are_tracked](core::SonarImage image) {
      if (are_tracked) note_ping(image.utime);
      if (are_tracked && figures_.is_fixed) add(core::VehicleState{image.utime, {}, {0.0, 0.0}});
      images_.add(image);
      if constexpr (requires { chain_.add(std::move(image)); }) chain_.add(std::move(image));
    });
  }

  /// Records a scan that was made of an image.
  void keep(const core::SonarScan& scan) { recorder_.add(scan); }

  TrackedRun run(const std::vector<std::string>& files) {
    for (const auto& file : files) {
      lcmtypes::LogReader log(file);
      while (const auto message = log.next()) {
        log_utime_ = message->log_utime;
        inbox_.take(message->channel, message->bytes.data(), message->bytes.size());
      }
    }
    chain_.finish();
    TrackedRun run{recorder_.finish(), chain_.output(), chain_.counts()};
    run.recording.is_fixed = figures_.is_fixed;
    run.recording.has_images = images_.close();
    figures_.images_left_out = images_.left_out();
    figures_.refusals = inbox_.refusals();
    figures_.refused_truth = recorder_.refused_truth();
    return run;
  }

 private:
  void note_ping(std::int64_t utime) {
    ++figures_.pings;
    figures_.stamps.add(utime, log_utime_);
  }
  void add(const core::VehicleState& state) {
    chain_.add(state);
    recorder_.add(state);
  }

  const lcmtypes::Channels& channels_;
  Chain& chain_;
  Recorder recorder_;
  ImageKeeper images_;
  LogFigures& figures_;
  lcmtypes::Inbox inbox_;
  std::int64_t log_utime_ = 0;  ///< Of the message that is taken [us].
};

/// Returns are found in the images, and tracked; scans beside them are left.
TrackedRun replay_detected(const std::vector<std::string>& files, const lcmtypes::Channels& channels,
                           const Configuration& configuration, std::uint64_t seed, LogFigures& figures,
                           const std::string& images_out) {
  std::function<void(const core::SonarScan&)> keep;
  RecordedDetectionChain chain(configuration, seed, [&keep](const core::SonarScan& scan) { keep(scan); });
  LogReplay replay(channels, chain, configuration.sensor, figures, images_out);
  keep = [&replay](const core::SonarScan& scan) { replay.keep(scan); };
  replay.take_images(true);
  TrackedRun run = replay.run(files);
  if (!run.recording.scans.empty())
    run.recording.params = core::with_geometry_of(run.recording.scans.front(), chain.sensor());
  return run;
}

/// Images are tracked; scans beside them are kept in the recording alone.
TrackedRun replay_images(const std::vector<std::string>& files, const lcmtypes::Channels& channels,
                         const Configuration& configuration, LogFigures& figures,
                         const std::string& images_out) {
  RecordedImageChain chain(configuration);
  LogReplay replay(channels, chain, configuration.sensor, figures, images_out);
  replay.take_scans(false);
  replay.take_images(true);
  return replay.run(files);
}

TrackedRun replay_scans(const std::vector<std::string>& files, const lcmtypes::Channels& channels,
                        const Configuration& configuration, std::uint64_t seed, LogFigures& figures,
                        const std::string& images_out) {
  RecordedChain chain(configuration, seed);
  LogReplay replay(channels, chain, configuration.sensor, figures, images_out);
  replay.take_scans(true);
  replay.take_images(false);
  return replay.run(files);
}

/// Tracks nothing.
struct NoChain {
  void add(const core::VehicleState& /*state*/) {}
  void finish() {}
  ChainOutput output() const { return {}; }
  tracking::IntakeCounts counts() const { return {}; }
};

/// @throws core::InputError where nothing came on the channel of the pings: what was refused there, else
/// which channels there are.
void require_pings(const std::string& file, const std::string& channel, const LogFigures& figures) {
  if (figures.pings > 0) return;
  std::string reasons;
  for (const auto& refusal : figures.refusals) {
    if (refusal.channel == channel)
      reasons +=
          (reasons.empty() ? "" : ", ") + std::to_string(refusal.count) + " x " + std::string(refusal.reason);
  }
  const auto found = figures.survey.channels.find(channel);
  if (found != figures.survey.channels.end())
    throw core::InputError(file + ": none of the " + std::to_string(found->second) + " messages on " +
                           channel + " could be used: " + reasons);
  throw core::InputError(file + ": holds no " + channel + "; its channels: " + figures.survey.names() +
                         " (--channel-prefix names the vehicle)");
}

}  // namespace

std::vector<std::string> notes_of(const LogFigures& figures, const core::Recording& recording) {
  std::vector<std::string> lines;
  const auto note = [&lines](bool holds, const std::string& line) {
    if (holds) lines.push_back(line);
  };
  const LogSurvey& survey = figures.survey;
  note(survey.damages > 0, "the log is damaged or cut off: " + std::to_string(survey.bytes_lost) +
                               " bytes in " + std::to_string(survey.damages) + " place(s) could not be read");
  for (const auto& refusal : figures.refusals) note(true, lcmtypes::text_of(refusal));
  if (const auto slower = figures.stamps.slower())
    note(true, "stamps go " + std::to_string(*slower) +
                   " times slower than the log's own clock: utime counts microseconds");
  note(figures.refused_truth > 0,
       std::to_string(figures.refused_truth) + " lists of truth at a time that has one already");
  note(figures.images_left_out > 0, std::to_string(figures.images_left_out) +
                                        " images that go back in time or repeat it are not in the recording");
  note(figures.is_fixed, "no vehicle states: a fixed sensor at the origin");
  note(!recording.new_clocks.empty(),
       "holds " + std::to_string(recording.new_clocks.size() + 1) +
           " clocks (played twice, appended, or set back): the recording numbers them in a column `clock`");
  return lines;
}

TrackedRun replay_log(const std::vector<std::string>& files, const std::string& channel_prefix,
                      const Configuration& configuration, std::uint64_t seed, LogFigures& figures,
                      const std::string& images_out) {
  const lcmtypes::Channels channels(channel_prefix);
  figures.survey = survey_log(files);
  TrackedRun run = configuration.detects
                       ? replay_detected(files, channels, configuration, seed, figures, images_out)
                   : tracks_images(configuration)
                       ? replay_images(files, channels, configuration, figures, images_out)
                       : replay_scans(files, channels, configuration, seed, figures, images_out);
  require_pings(files.front(), takes_images(configuration) ? channels.sonar_image() : channels.sonar_scan(),
                figures);
  return run;
}

core::Recording read_log(const std::vector<std::string>& files, const std::string& channel_prefix,
                         const core::SonarParams& sensor, LogFigures& figures) {
  const lcmtypes::Channels channels(channel_prefix);
  figures.survey = survey_log(files);
  NoChain chain;
  LogReplay replay(channels, chain, sensor, figures, "");
  replay.take_scans(true);
  core::Recording recording = replay.run(files).recording;
  require_pings(files.front(), channels.sonar_scan(), figures);
  return recording;
}

core::Recording detect_log(const std::vector<std::string>& files, const std::string& channel_prefix,
                           FoundReturns& found) {
  const lcmtypes::Channels channels(channel_prefix);
  LogFigures figures;
  figures.survey = survey_log(files);
  LogReplay replay(channels, found, core::SonarParams{}, figures, "");
  found.give_to([&replay](const core::SonarScan& scan) { replay.keep(scan); });
  replay.take_images(true);
  core::Recording recording = replay.run(files).recording;
  recording.params.reset();
  found.give_to({});
  require_pings(files.front(), channels.sonar_image(), figures);
  return recording;
}

std::optional<std::int64_t> first_difference(const std::vector<core::TrackList>& a,
                                             const std::vector<core::TrackList>& b) {
  const std::size_t common = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < common; ++i) {
    if (!same(a[i], b[i])) return std::min(a[i].utime, b[i].utime);
  }
  return std::nullopt;
}

}  // namespace lookout::tools
