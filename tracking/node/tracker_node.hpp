#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/pose_history.hpp"
#include "tracking/detection_chain.hpp"
#include "tracking/intake/stamp_clock.hpp"
#include "tracking/node/ping_node.hpp"
#include "tracking/track_before_detect/images/image_chain.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tracking {

/// The on-vehicle process around a chain: VEHICLE_STATE and the chain's pings in (SONAR_SCAN or SONAR_IMAGE);
/// MOTION_ELEMENTS, TRACKS and, where the method has it, SENSOR_ESTIMATE out, once for each accepted ping;
/// LOOKOUT_STATUS every second. What arrives waits in a queue of bounded length: pings that come faster than
/// they can be tracked shed the oldest, which is counted and told.
template <class Chain>
class ChainNode {
 public:
  using Report = std::function<void(const std::string&)>;
  using Ping = typename Chain::Ping;
  /// Makes the chain, given who receives its results and its lines for a person.
  using MakeChain = std::function<std::unique_ptr<Chain>(typename Chain::OnResult, Report)>;

  /// @param report receives lines for a person.
  /// @throws core::InputError on a bad prefix or node_id, or a state file for images; what `make_chain`
  /// throws.
  ChainNode(lcmtypes::Bus& bus, const TrackerNodeParams& params, const MakeChain& make_chain, Report report);

  /// Works until a limit is reached; then tracks what has arrived, rejects what still waits for a pose, keeps
  /// the state and publishes a last status.
  void run(const lcmtypes::LoopLimits& limits);

  const LocalEstimateSender& link() const { return node_.link(); }  ///< Of LOCAL_ESTIMATE, for its counts.
  lcmtypes::NodeFigures figures() const;                            ///< As LOOKOUT_STATUS gives them.
  /// Pings and vehicle states, accepted and rejected.
  const IntakeCounts& counts() const { return chain_->counts(); }
  double latency(double share) const { return node_.latency(share); }  ///< Percentile [ms].
  std::string stages() const { return node_.stages(); }                ///< Of the latency, see PingNode.
  const NodeHealth& health() const { return node_.health(); }          ///< As of the newest status.

 private:
  /// A message that has arrived.
  struct Arrived {
    PingNode::Clock::time_point arrival;
    std::variant<core::VehicleState, Ping> data;
  };

  void listen();
  void take(std::variant<core::VehicleState, Ping> data);
  void watch_stamps(std::int64_t utime);
  void shed_oldest();
  bool must_end(const lcmtypes::LoopLimits& limits);
  bool work();
  void handle(Arrived arrived);
  void publish(const PingResult& result);
  void every_second(const lcmtypes::LoopLimits& limits);
  void publish_status();
  void load_state();
  void save_state();

  lcmtypes::Bus& bus_;
  TrackerNodeParams params_;
  std::size_t max_waiting_;
  PingNode node_;
  std::unique_ptr<Chain> chain_;
  std::deque<Arrived> queue_;
  std::size_t pings_waiting_ = 0;
  StampClock stamps_;
  std::optional<PingNode::Clock::time_point> stopped_at_;  // When a stop signal was first seen.
  int seconds_ = 0;                                        // Of status, since the state was kept.
  std::vector<std::int64_t> kept_;  // Confirmed identities in the state as it was last kept.
};

extern template class ChainNode<TrackingChain>;
extern template class ChainNode<ImageChain>;
extern template class ChainNode<DetectionChain>;

using TrackerNode = ChainNode<TrackingChain>;            ///< On scans.
using ImageTrackerNode = ChainNode<ImageChain>;          ///< On raw images.
using DetectionTrackerNode = ChainNode<DetectionChain>;  ///< On the returns that it finds in images.

}  // namespace lookout::tracking
