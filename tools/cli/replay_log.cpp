#include "tools/cli/replay_log.hpp"

#include <algorithm>

#include "core/field_of_view.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/inbox.hpp"
#include "lcmtypes/log_reader.hpp"

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

/// Takes every message of the log; scans and images reach the chain by what `inbox` holds for them already.
template <class Chain>
void take_log(const std::string& path, const lcmtypes::Channels& channels, lcmtypes::Inbox& inbox,
              Chain& chain, TrackedRun& run, LogFigures& figures) {
  inbox.on<vehicle_state_t>(channels.vehicle_state(), [&](const core::VehicleState& state) {
    run.recording.vehicle.push_back(state);
    chain.add(state);
  });
  inbox.on<ground_truth_t>(channels.ground_truth(),
                           [&](core::GroundTruth truth) { run.recording.truth.push_back(std::move(truth)); });
  inbox.on<track_list_t>(channels.tracks(), [&](lcmtypes::KeyedTracks tracks) {
    figures.tracks.push_back({tracks.key.utime, std::move(tracks.tracks)});
  });
  lcmtypes::LogReader log(path);
  while (const auto message = log.next())
    inbox.take(message->channel, message->bytes.data(), message->bytes.size());
  chain.finish();
  figures.messages = log.messages();
  figures.damages = log.damages();
  figures.bytes_lost = log.bytes_lost();
  figures.bad_messages = inbox.bad_messages();
  run.output = chain.output();
  run.counts = chain.counts();
}

/// Images are tracked; scans beside them are kept in the recording alone.
void replay_images(const std::string& path, const lcmtypes::Channels& channels,
                   const Configuration& configuration, TrackedRun& run, LogFigures& figures) {
  RecordedImageChain chain(configuration);
  lcmtypes::Inbox inbox;
  inbox.on<sonar_scan_t>(channels.sonar_scan(),
                         [&](const core::SonarScan& scan) { run.recording.scans.push_back(scan); });
  inbox.on<sonar_image_t>(channels.sonar_image(), [&](const core::SonarImage& image) {
    ++figures.pings;
    chain.add(image);
  });
  take_log(path, channels, inbox, chain, run, figures);
}

void replay_scans(const std::string& path, const lcmtypes::Channels& channels,
                  const Configuration& configuration, std::uint64_t seed, TrackedRun& run,
                  LogFigures& figures) {
  RecordedChain chain(configuration, seed);
  lcmtypes::Inbox inbox;
  inbox.on<sonar_scan_t>(channels.sonar_scan(), [&](const core::SonarScan& scan) {
    ++figures.pings;
    run.recording.scans.push_back(scan);
    chain.add(scan);
  });
  take_log(path, channels, inbox, chain, run, figures);
}

}  // namespace

TrackedRun replay_log(const std::string& path, const std::string& channel_prefix,
                      const Configuration& configuration, std::uint64_t seed, LogFigures& figures) {
  const lcmtypes::Channels channels(channel_prefix);
  TrackedRun run;
  if (tracks_images(configuration))
    replay_images(path, channels, configuration, run, figures);
  else
    replay_scans(path, channels, configuration, seed, run, figures);
  keep_in_order(run.recording.vehicle);
  run.recording.params = run.recording.scans.empty()
                             ? configuration.sensor
                             : core::with_geometry_of(run.recording.scans.front(), configuration.sensor);
  return run;
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
