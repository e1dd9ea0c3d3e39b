#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "core/motion_element.hpp"
#include "core/sensor_estimate.hpp"
#include "core/sonar_params.hpp"
#include "core/track.hpp"
#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/node_loop.hpp"
#include "lcmtypes/status_board.hpp"
#include "tracking/node/local_estimate_sender.hpp"

namespace lookout::tracking {

struct TrackerNodeParams {
  std::string channel_prefix;
  std::int32_t node_id = 1;  ///< >= 1; 0 is for programs that track nothing.
  core::SonarParams sensor;  ///< What the configuration says of the sensor.
  core::EstimatorMethod method = core::EstimatorMethod::csht;  ///< Named in MOTION_ELEMENTS.
  int window_scans = 20;                                       ///< Likewise.
  bool publish_estimates = false;                              ///< Also LOCAL_ESTIMATE.
  std::int64_t lag = 0;            ///< Delay of the output [us]: tracks as they are known so much later.
  LocalEstimateSenderParams link;  ///< What carries them; with our node_id.
};

/// What a tracking node says of one ping; everything is valid until it has been published.
struct PingReport {
  lcmtypes::ScanKey key;          ///< Of the scan or the image.
  Eigen::Vector2d p_earth_sonar;  ///< Where it was taken [m].
  std::span<const core::MotionElement> elements;
  std::span<const core::Track> tracks;
  std::optional<core::SensorEstimate> sensor_estimate;
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
  }  ///< Of the message that is handled now.
  void publish(const PingReport& ping);
  void note(const std::string& line);  ///< For a person, and for the status until another comes.
  void publish_status(const lcmtypes::NodeFigures& figures);

  const lcmtypes::Channels& channels() const { return channels_; }
  const LocalEstimateSender& link() const { return sender_; }
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

/// The figures of a chain whose pings come on `channel`.
template <class Chain>
lcmtypes::NodeFigures figures_of(const Chain& chain, const lcmtypes::Inbox& inbox,
                                 const std::string& channel) {
  const auto& counts = chain.counts();
  return {chain.newest_utime(), counts.accepted, counts.rejected() + counts.bad_states + inbox.bad_messages(),
          inbox.counts(channel).lost};
}

}  // namespace lookout::tracking
