#pragma once

#include "tracking/node/ping_node.hpp"
#include "tracking/track_before_detect/images/image_chain.hpp"

namespace lookout::tracking {

/// The on-vehicle process on raw images: VEHICLE_STATE and SONAR_IMAGE in; MOTION_ELEMENTS and TRACKS out,
/// once for each accepted image; LOOKOUT_STATUS every second. Of TrackerNodeParams it has no use for
/// `method`, `window_scans` and `lag`.
class ImageTrackerNode {
 public:
  /// @throws core::InputError on a bad prefix or node_id.
  ImageTrackerNode(lcmtypes::Bus& bus, const TrackerNodeParams& params, ImageChain::Report report);

  /// Works until a limit is reached; then rejects what still waits and publishes a last status.
  void run(const lcmtypes::LoopLimits& limits);

  const LocalEstimateSender& link() const { return node_.link(); }
  lcmtypes::NodeFigures figures() const;
  const IntakeCounts& counts() const { return chain_.counts(); }
  double latency(double share) const { return node_.latency(share); }  ///< Percentile [ms].

 private:
  void publish(const core::PosedImage& posed, std::span<const core::Track> tracks);

  lcmtypes::Bus& bus_;
  PingNode node_;
  ImageChain chain_;
};

}  // namespace lookout::tracking
