#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tracking/node/ping_node.hpp"
#include "tracking/track_before_detect/images/image_chain.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tracking {

/// The on-vehicle process around a chain: VEHICLE_STATE and the chain's pings in (SONAR_SCAN or SONAR_IMAGE);
/// MOTION_ELEMENTS, TRACKS and, where the method has it, SENSOR_ESTIMATE out, once for each accepted ping;
/// LOOKOUT_STATUS every second.
template <class Chain>
class ChainNode {
 public:
  using Report = std::function<void(const std::string&)>;
  /// Makes the chain, given who receives its results and its lines for a person.
  using MakeChain = std::function<std::unique_ptr<Chain>(typename Chain::OnResult, Report)>;

  /// @param report receives lines for a person.
  /// @throws core::InputError on a bad prefix or node_id; what `make_chain` throws.
  ChainNode(lcmtypes::Bus& bus, const TrackerNodeParams& params, const MakeChain& make_chain, Report report);

  /// Works until a limit is reached; then rejects what still waits and publishes a last status.
  void run(const lcmtypes::LoopLimits& limits);

  const LocalEstimateSender& link() const { return node_.link(); }  ///< Of LOCAL_ESTIMATE, for its counts.
  lcmtypes::NodeFigures figures() const;                            ///< As LOOKOUT_STATUS gives them.
  /// Pings and vehicle states, accepted and rejected.
  const IntakeCounts& counts() const { return chain_->counts(); }
  double latency(double share) const { return node_.latency(share); }  ///< Percentile [ms].

 private:
  lcmtypes::Bus& bus_;
  PingNode node_;
  std::unique_ptr<Chain> chain_;
};

extern template class ChainNode<TrackingChain>;
extern template class ChainNode<ImageChain>;

using TrackerNode = ChainNode<TrackingChain>;    ///< On scans.
using ImageTrackerNode = ChainNode<ImageChain>;  ///< On raw images.

}  // namespace lookout::tracking
