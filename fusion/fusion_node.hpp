#pragma once

#include <cstdint>
#include <optional>

#include "fusion/fusion.hpp"
#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/node_loop.hpp"
#include "lcmtypes/status_board.hpp"

namespace lookout::fusion {

/// What the node is told; fusion.hpp and fusion_params.hpp say of what.
struct FusionNodeParams {
  std::string channel_prefix;  ///< Of LOOKOUT_STATUS alone: the data channels are shared between vehicles.
  FusionParams fusion;         ///< Of the fusion itself.
};

/// LOCAL_ESTIMATE of any number of nodes in, GLOBAL_TRACKS out: one list for each time that the nodes' common
/// clock shows, published when a newer estimate comes or within a second of the last one; LOOKOUT_STATUS
/// every second.
class FusionNode {
 public:
  /// @throws core::InputError on a bad prefix; std::invalid_argument on a bad parameter.
  FusionNode(lcmtypes::Bus& bus, const FusionNodeParams& params);

  /// Works until a limit is reached; then publishes what still waits and a last status.
  void run(const lcmtypes::LoopLimits& limits);

  const Fusion& fusion() const { return fusion_; }       ///< What the node feeds, for its counts.
  std::int64_t published() const { return published_; }  ///< Lists sent.
  std::int64_t refused() const;                          ///< Messages that changed nothing.

 private:
  void take(const core::LocalEstimate& estimate);
  void publish_pending();
  void every_second();

  lcmtypes::Bus& bus_;
  lcmtypes::Channels channels_;
  lcmtypes::StatusBoard status_;
  Fusion fusion_;
  std::optional<std::int64_t> pending_;  ///< The time to fuse once all its estimates are in [us].
  bool heard_since_second_ = false;
  std::int64_t published_ = 0;
  std::int64_t left_out_ = 0;  ///< Tracks above what a message holds.
};

}  // namespace lookout::fusion
