#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/node_loop.hpp"
#include "lcmtypes/status_board.hpp"
#include "tracking/node/local_estimate_sender.hpp"
#include "tracking/ping_result.hpp"

namespace lookout::tracking {

/// What a tracking node is told beside the tracker.
struct TrackerNodeParams {
  std::string channel_prefix;      ///< Before the vehicle's channel names.
  std::int32_t node_id = 1;        ///< >= 1; 0 is for programs that track nothing.
  bool publish_estimates = false;  ///< Also LOCAL_ESTIMATE.
  LocalEstimateSenderParams link;  ///< What carries them; with our node_id.
};

/// What the nodes of scans and of images have in common, the publishing: MOTION_ELEMENTS, SENSOR_ESTIMATE,
/// LOCAL_ESTIMATE within the link's rate, TRACKS, and LOOKOUT_STATUS with the latency from a ping's arrival.
class PingNode {
 public:
  using Report = std::function<void(const std::string&)>;

  /// @param report receives lines for a person. @throws core::InputError on a bad prefix or node_id.
  PingNode(lcmtypes::Bus& bus, const TrackerNodeParams& params, Report report);

  void note_arrival() {
    arrival_ = lcmtypes::NodeLoop::Clock::now();
  }                                      ///< Of the message that is handled now.
  void publish(const PingResult& ping);  ///< Sends all that the result holds, empty lists included.
  void note(const std::string& line);    ///< For a person, and for the status until another comes.
  void publish_status(const lcmtypes::NodeFigures& figures);  ///< Sends LOOKOUT_STATUS.

  const lcmtypes::Channels& channels() const { return channels_; }  ///< With the prefix.
  const LocalEstimateSender& link() const { return sender_; }       ///< Of LOCAL_ESTIMATE, for its counts.
  double latency(double share) const { return status_.latency(share); }  ///< Percentile [ms].

 private:
  lcmtypes::Bus& bus_;
  TrackerNodeParams params_;
  lcmtypes::Channels channels_;
  Report report_;
  std::string last_error_;
  lcmtypes::StatusBoard status_;
  LocalEstimateSender sender_;
  lcmtypes::NodeLoop::Clock::time_point arrival_;
};

}  // namespace lookout::tracking
