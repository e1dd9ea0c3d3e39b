#pragma once

#include "tracking/node/ping_node.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tracking {

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

  const LocalEstimateSender& link() const { return node_.link(); }
  lcmtypes::NodeFigures figures() const;
  const IntakeCounts& counts() const { return chain_.counts(); }
  double latency(double share) const { return node_.latency(share); }  ///< Percentile [ms].

 private:
  void publish(const ScanResult& result);

  lcmtypes::Bus& bus_;
  PingNode node_;
  TrackingChain chain_;
};

}  // namespace lookout::tracking
