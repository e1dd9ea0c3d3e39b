#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/node_loop.hpp"
#include "lcmtypes/status_board.hpp"
#include "tracking/node/local_estimate_sender.hpp"
#include "tracking/node/node_health.hpp"
#include "tracking/ping_result.hpp"

namespace lookout::tracking {

/// What a tracking node is told beside the tracker.
struct TrackerNodeParams {
  std::string channel_prefix;      ///< Before the vehicle's channel names.
  std::int32_t node_id = 1;        ///< >= 1; 0 is for programs that track nothing.
  bool publish_estimates = false;  ///< Also LOCAL_ESTIMATE.
  /// Also CLUTTER_MAP, at most so often in data time [s], > 0; nothing: never.
  std::optional<double> clutter_every = std::nullopt;
  /// Lines that the tracker wrote of its decisions, a line feed behind each: sent as DECISIONS and cleared
  /// with each ping; null: never.
  std::shared_ptr<std::string> decisions = nullptr;
  LocalEstimateSenderParams link;  ///< What carries them; with our node_id.
  /// Pings that may wait for the tracker; a newer one sheds the oldest. Nothing: kMaxWaiting on a link that
  /// does not wait for us, else no limit.
  std::optional<std::size_t> max_waiting = std::nullopt;
  std::string state_file;  ///< Where the tracker's memory is kept for a restart; empty: nowhere.
  /// Asked while that memory is tracked again: true once a stop signal came.
  std::function<bool()> stopped = [] { return false; };

  static constexpr std::size_t kMaxWaiting = 16;  ///< Eight seconds of Table 7's sonar. Own choice.
};

/// What the nodes of scans and of images have in common, the publishing: MOTION_ELEMENTS, SENSOR_ESTIMATE,
/// LOCAL_ESTIMATE within the link's rate, TRACKS, where asked for DECISIONS and now and then CLUTTER_MAP, and
/// LOOKOUT_STATUS with the latency from a ping's arrival.
class PingNode {
 public:
  using Report = std::function<void(const std::string&)>;

  /// @param report receives lines for a person. @throws core::InputError on a bad prefix or node_id.
  PingNode(lcmtypes::Bus& bus, const TrackerNodeParams& params, Report report);

  using Clock = lcmtypes::NodeLoop::Clock;

  /// A message is handled now that arrived then.
  void note_handling(Clock::time_point arrival) {
    arrival_ = arrival;
    handling_ = Clock::now();
  }
  void publish(const PingResult& ping);  ///< Sends all that the result holds, empty lists included.
  void note(const std::string& line);    ///< For a person, and for the status until another comes.
  /// Sends LOOKOUT_STATUS; `sample` says what was counted, for the state in it.
  void publish_status(const lcmtypes::NodeFigures& figures, HealthSample sample);

  const lcmtypes::Channels& channels() const { return channels_; }  ///< With the prefix.
  const LocalEstimateSender& link() const { return sender_; }       ///< Of LOCAL_ESTIMATE, for its counts.
  double latency(double share) const { return status_.latency(share); }  ///< Percentile [ms].
  const NodeHealth& health() const { return health_; }                   ///< As of the newest status.
  /// The parts of the latency, for a person: percentiles of waiting, work and sending.
  std::string stages() const;

 private:
  void publish_clutter(const PingResult& ping);
  void publish_decisions(const PingResult& ping);
  void hear_status(std::span<const std::uint8_t> bytes);

  lcmtypes::Bus& bus_;
  TrackerNodeParams params_;
  lcmtypes::Channels channels_;
  Report report_;
  std::string last_error_;
  lcmtypes::StatusBoard status_;
  LocalEstimateSender sender_;
  NodeHealth health_;
  double miss_probability_ = 0.0;              ///< The newest that was learnt; 0: none.
  std::optional<std::int64_t> clutter_utime_;  ///< Of the ping with the newest CLUTTER_MAP [us].
  std::int64_t twins_ = 0;                     ///< Statuses of another tracker under our name.
  Clock::time_point arrival_, handling_;
  lcmtypes::LatencyWindow waiting_, working_, sending_;
};

}  // namespace lookout::tracking
