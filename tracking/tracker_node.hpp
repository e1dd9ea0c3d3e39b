#pragma once

#include <cstdint>
#include <string>

#include "core/motion_element.hpp"
#include "core/sonar_params.hpp"
#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/node_loop.hpp"
#include "lcmtypes/status_board.hpp"
#include "tracking/local_estimate_sender.hpp"
#include "tracking/tracking_chain.hpp"

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

/// The on-vehicle process: VEHICLE_STATE and SONAR_SCAN in; MOTION_ELEMENTS, TRACKS and, where the tracker
/// has it, SENSOR_ESTIMATE out, once for each accepted scan; LOOKOUT_STATUS every second.
class TrackerNode {
 public:
  using Report = TrackingChain::Report;

  /// @param report receives lines for a person.
  /// @throws core::InputError on a bad prefix or node_id.
  TrackerNode(lcmtypes::Bus& bus, const TrackerNodeParams& params, TrackingChain::MakeTracker make_tracker,
              Report report);

  /// Works until a limit is reached; then rejects what still waits and publishes a last status.
  void run(const lcmtypes::LoopLimits& limits);

  const LocalEstimateSender& link() const { return sender_; }
  lcmtypes::NodeFigures figures() const;
  const IntakeCounts& counts() const { return chain_.counts(); }
  double latency(double share) const { return status_.latency(share); }  ///< Percentile [ms].

 private:
  void publish(const ScanResult& result);
  void publish_estimates(const core::PosedScan& scan, std::span<const core::Track> tracks);
  template <class Data>
  void take(Data data);
  void note(const std::string& line);
  void publish_status();

  lcmtypes::Bus& bus_;
  TrackerNodeParams params_;
  lcmtypes::Channels channels_;
  Report report_;
  std::string last_error_;
  lcmtypes::StatusBoard status_;
  TrackingChain chain_;
  LocalEstimateSender sender_;
  lcmtypes::NodeLoop::Clock::time_point arrival_;  ///< Of the message that is being handled.
  std::int64_t left_out_ = 0;                      ///< Tracks and elements above what a message holds.
};

}  // namespace lookout::tracking
