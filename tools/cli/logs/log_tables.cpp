#include "tools/cli/logs/log_tables.hpp"

#include <vector>

#include "core/field_of_view.hpp"
#include "core/files/csv.hpp"
#include "core/files/recording.hpp"
#include "core/input_error.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/convert_reports.hpp"
#include "lcmtypes/inbox.hpp"
#include "lcmtypes/log_reader.hpp"
#include "tools/cli/tracked_run.hpp"

namespace lookout::tools {
namespace {

struct LogContent {
  core::Recording recording;
  std::vector<lcmtypes::KeyedTracks> tracks;
  std::vector<lcmtypes::KeyedTracks> global_tracks;  ///< Of the fusion, drawn where there are no others.
  std::vector<lcmtypes::OspaReport> ospa;
  std::vector<std::string> left_out;  ///< A line for each kind.

  bool empty() const {
    return recording.scans.empty() && recording.vehicle.empty() && tracks.empty() && global_tracks.empty() &&
           ospa.empty();
  }
};

LogContent read(const std::string& path, const lcmtypes::Channels& channels) {
  LogContent content;
  lcmtypes::Inbox inbox;
  inbox.on<vehicle_state_t>(channels.vehicle_state(), [&](const core::VehicleState& state) {
    content.recording.vehicle.push_back(state);
  });
  inbox.on<sonar_scan_t>(channels.sonar_scan(),
                         [&](core::SonarScan scan) { content.recording.scans.push_back(std::move(scan)); });
  inbox.on<ground_truth_t>(channels.ground_truth(), [&](core::GroundTruth truth) {
    content.recording.truth.push_back(std::move(truth));
  });
  inbox.on<track_list_t>(channels.tracks(),
                         [&](lcmtypes::KeyedTracks tracks) { content.tracks.push_back(std::move(tracks)); });
  inbox.on<track_list_t>(lcmtypes::Channels::kGlobalTracks, [&](lcmtypes::KeyedTracks tracks) {
    content.global_tracks.push_back(std::move(tracks));
  });
  inbox.on_read(channels.ospa(), &lcmtypes::read_ospa,
                [&](const lcmtypes::OspaReport& report) { content.ospa.push_back(report); });
  lcmtypes::LogReader log(path);
  while (const auto message = log.next())
    inbox.take(message->channel, message->bytes.data(), message->bytes.size());
  for (const auto& refusal : inbox.refusals()) content.left_out.push_back(lcmtypes::text_of(refusal));
  if (log.damages() > 0)
    content.left_out.push_back(std::to_string(log.damages()) + " stretches of the log cannot be read");
  return content;
}

void write_tracks(const std::string& path, const std::vector<lcmtypes::KeyedTracks>& lists) {
  core::CsvWriter csv(path,
                      "time_s,id,status,north_m,east_m,north_velocity_mps,east_velocity_mps,existence,moving,"
                      "covariance_nn_m2,covariance_ne_m2,covariance_ee_m2");
  for (const auto& list : lists) {
    for (const auto& track : list.tracks) {
      csv.number(core::seconds(list.key.utime)).integer(track.id).text(core::to_string(track.status));
      for (const double value : track.state) csv.number(value);
      csv.number(track.existence)
          .number(track.moving)
          .number(track.covariance(0, 0))
          .number(track.covariance(0, 1));
      csv.number(track.covariance(1, 1)).end_row();
    }
  }
  csv.close();
}

void write_ospa(const std::string& path, const std::vector<lcmtypes::OspaReport>& reports) {
  core::CsvWriter csv(path, "time_s,total,localization,cardinality,num_truth,num_tracks");
  for (const auto& report : reports)
    csv.number(core::seconds(report.utime))
        .number(report.total)
        .number(report.localization)
        .number(report.cardinality)
        .integer(report.num_truth)
        .integer(report.num_tracks)
        .end_row();
  csv.close();
}

/// Keeps the vehicle states that a recording holds: each later than all before it. @return how many go.
std::size_t keep_in_order(std::vector<core::VehicleState>& vehicle) {
  std::vector<core::VehicleState> kept;
  for (const auto& state : vehicle)
    if (kept.empty() || state.utime > kept.back().utime) kept.push_back(state);
  const std::size_t left_out = vehicle.size() - kept.size();
  vehicle = std::move(kept);
  return left_out;
}

}  // namespace

std::vector<std::string> write_log_tables(const std::string& log, const std::string& channel_prefix,
                                          const std::string& directory) {
  const lcmtypes::Channels channels(channel_prefix);
  LogContent content = read(log, channels);
  if (content.empty())
    throw core::InputError(log + ": holds no SONAR_SCAN, VEHICLE_STATE, TRACKS, OSPA or GLOBAL_TRACKS" +
                           (channel_prefix.empty() ? "; perhaps a --channel-prefix is needed"
                                                   : " with the prefix " + channel_prefix));
  if (const std::size_t back = keep_in_order(content.recording.vehicle); back > 0)
    content.left_out.push_back(channels.vehicle_state() + ": " + std::to_string(back) +
                               " states that are not later than all before them are left out");
  if (!content.recording.scans.empty())
    content.recording.params = core::with_geometry_of(content.recording.scans.front(), {});
  core::write_recording(directory, content.recording);
  const auto& tracks = content.tracks.empty() ? content.global_tracks : content.tracks;
  if (!tracks.empty()) write_tracks(directory + "/tracks.csv", tracks);
  if (!content.ospa.empty()) write_ospa(directory + "/ospa.csv", content.ospa);
  return content.left_out;
}

}  // namespace lookout::tools
