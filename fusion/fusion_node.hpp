#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>

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
  /// Estimates that may wait; nothing: kMostWaiting on a link that does not wait for us, else no limit.
  std::optional<std::size_t> max_waiting = std::nullopt;

  static constexpr std::size_t kMostWaiting = 4096;  ///< Of all nodes. Own choice.
};

/// LOCAL_ESTIMATE of any number of nodes in, GLOBAL_TRACKS out: one list for each time that the nodes' common
/// clock shows, published when a newer estimate comes or within a second of the last one; LOOKOUT_STATUS
/// every second. Estimates that come faster than they can be fused wait in a queue of bounded length, from
/// which the oldest of the node that has most of them there is shed: counted, and no other node's.
class FusionNode {
 public:
  /// @throws core::InputError on a bad prefix; std::invalid_argument on a bad parameter.
  FusionNode(lcmtypes::Bus& bus, const FusionNodeParams& params);

  /// Works until a limit is reached; then publishes what still waits and a last status.
  void run(const lcmtypes::LoopLimits& limits);

  const Fusion& fusion() const { return fusion_; }       ///< What the node feeds, for its counts.
  std::int64_t published() const { return published_; }  ///< Lists sent.
  std::int64_t refused() const;                          ///< Messages that changed nothing.
  std::int64_t shed() const { return shed_; }            ///< Estimates for which there was no time.
  std::int64_t leaps() const { return leaps_; }          ///< Of nodes' positions: two senders under one id.

  static constexpr std::size_t kMostWatched = 64;  ///< Nodes whose position is watched.
  static constexpr double kLeap = 50.0;            ///< A position may be off by so much [m] ...
  static constexpr double kFastest = 20.0;         ///< ... and move by so much [m/s].

 private:
  void take(const core::LocalEstimate& estimate);
  void shed_one();
  bool work();
  void finish(const lcmtypes::LoopLimits& limits);
  void fuse(const core::LocalEstimate& estimate);
  void watch_sender(const core::LocalEstimate& estimate);
  std::string troubles() const;
  std::string refusals() const;
  void publish_pending();
  void every_second();

  lcmtypes::Bus& bus_;
  lcmtypes::Channels channels_;
  lcmtypes::StatusBoard status_;
  Fusion fusion_;
  std::size_t max_waiting_;
  std::optional<std::int64_t> pending_;  ///< The time to fuse once all its estimates are in [us].
  bool heard_since_second_ = false;
  std::int64_t published_ = 0;
  std::map<std::int32_t, core::LocalEstimate> newest_of_;  ///< Of each node, kMostWatched of them.
  std::int64_t leaps_ = 0;                                 ///< Of a node's position, which no vehicle makes.
  std::int32_t leaping_node_ = 0;                          ///< The newest that did.
  std::deque<core::LocalEstimate> waiting_;
  std::map<std::int32_t, std::size_t> waiting_of_;  ///< How many of `waiting_` are a node's.
  std::int64_t shed_ = 0;
  std::int64_t left_out_ = 0;  ///< Tracks above what a message holds.
};

}  // namespace lookout::fusion
