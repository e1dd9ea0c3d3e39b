#include "tools/cli/logs/log_recording.hpp"

#include "core/files/time_text.hpp"
#include "core/input_error.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/convert.hpp"
#include "lcmtypes/log_writer.hpp"
#include "tools/cli/scan_feed.hpp"

namespace lookout::tools {
namespace {

/// Takes a recording as a chain would, and writes it.
class LogSink {
 public:
  LogSink(const std::string& path, const core::Recording& recording,
          const std::vector<core::TrackList>& tracks, const std::string& channel_prefix)
      : channels_(channel_prefix), recording_(recording), tracks_(tracks), log_(path) {}

  void add(const core::VehicleState& state) {
    if (!recording_.is_fixed) log_.add(channels_.vehicle_state(), state.utime, lcmtypes::to_wire(state));
  }

  void add(const core::SonarScan& scan) {
    log_.add(channels_.sonar_scan(), scan.utime, lcmtypes::to_wire(scan));
    while (next_truth_ < end_of_truth() && recording_.truth[next_truth_].utime <= scan.utime) add_truth();
    if (next_tracks_ < tracks_.size() && tracks_[next_tracks_].utime == scan.utime) add_tracks(scan);
  }

  void start_new_clock() {
    while (next_truth_ < end_of_truth()) add_truth();
    ++clock_;
  }

  void close() {
    while (next_truth_ < recording_.truth.size()) add_truth();
    if (next_tracks_ < tracks_.size())
      throw core::InputError("tracks: those at " + core::time_text(tracks_[next_tracks_].utime) +
                             " s belong to no scan; expected lists at the times of scans, in order");
    log_.close();
  }

 private:
  std::size_t end_of_truth() const {
    return clock_ < recording_.new_clocks.size() ? recording_.new_clocks[clock_].truth
                                                 : recording_.truth.size();
  }

  void add_truth() {
    const core::GroundTruth& truth = recording_.truth[next_truth_++];
    log_.add(channels_.ground_truth(), truth.utime, lcmtypes::to_wire(truth));
  }

  void add_tracks(const core::SonarScan& scan) {
    const core::TrackList& list = tracks_[next_tracks_++];
    const auto wire = lcmtypes::to_wire({scan.utime, scan.sequence, scan.sensor_id}, list.tracks);
    if (wire.left_out > 0)
      throw core::InputError("tracks: " + std::to_string(list.tracks.size()) + " at " +
                             core::time_text(list.utime) + " s, expected at most " +
                             std::to_string(lcmtypes::kMaxListed));
    log_.add(channels_.tracks(), scan.utime, wire.message);
  }

  lcmtypes::Channels channels_;
  const core::Recording& recording_;
  const std::vector<core::TrackList>& tracks_;
  lcmtypes::LogWriter log_;
  std::size_t next_truth_ = 0, next_tracks_ = 0, clock_ = 0;
};

}  // namespace

void write_log(const std::string& path, const core::Recording& recording,
               const std::vector<core::TrackList>& tracks, const std::string& channel_prefix) {
  LogSink sink(path, recording, tracks, channel_prefix);
  feed_scans(sink, recording);
  sink.close();
}

}  // namespace lookout::tools
