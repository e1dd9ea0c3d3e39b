#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/node_loop.hpp"
#include "lcmtypes/status_board.hpp"
#include "tracking/track_before_detect/image_chain.hpp"
#include "tracking/tracker_node.hpp"

namespace lookout::tracking {

/// The on-vehicle process on raw images: VEHICLE_STATE and SONAR_IMAGE in; MOTION_ELEMENTS and TRACKS out,
/// once for each accepted image; LOOKOUT_STATUS every second. Of TrackerNodeParams it reads prefix, node id,
/// sensor and publish_estimates.
class ImageTrackerNode {
 public:
  /// @throws core::InputError on a bad prefix or node_id.
  ImageTrackerNode(lcmtypes::Bus& bus, const TrackerNodeParams& params, ImageChain::Report report);

  /// Works until a limit is reached; then rejects what still waits and publishes a last status.
  void run(const lcmtypes::LoopLimits& limits);

  lcmtypes::NodeFigures figures() const;
  const IntakeCounts& counts() const { return chain_.counts(); }
  double latency(double share) const { return status_.latency(share); }  ///< Percentile [ms].

 private:
  void publish(const core::PosedImage& posed, std::span<const core::Track> tracks);
  void note(const std::string& line);
  void publish_status();

  lcmtypes::Bus& bus_;
  TrackerNodeParams params_;
  lcmtypes::Channels channels_;
  ImageChain::Report report_;
  std::string last_error_;
  lcmtypes::StatusBoard status_;
  ImageChain chain_;
  lcmtypes::NodeLoop::Clock::time_point arrival_;  ///< Of the message that is being handled.
};

}  // namespace lookout::tracking
