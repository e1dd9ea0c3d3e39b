#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "lcmtypes/bus.hpp"
#include "lcmtypes/latency_window.hpp"

namespace lookout::lcmtypes {

/// What a node has done so far, for LOOKOUT_STATUS.
struct NodeFigures {
  std::int64_t utime = 0;     ///< Of the newest data, scenario time [us].
  std::int64_t accepted = 0;  ///< Scans (a scorer: truths; a simulator: scans sent).
  std::int64_t rejected = 0;  ///< Messages refused, for whatever reason.
  std::int64_t dropped = 0;   ///< Lost on the way, by sequence.
  std::int64_t shed = 0;      ///< Whole, but left out under overload.
};

/// Publishes a node's status.
class StatusBoard {
 public:
  /// @param node_id of a vehicle's tracker; 0 of sim, score and fuse, which --wait-for does not count.
  StatusBoard(Bus& bus, std::string channel, std::string node, std::int32_t node_id);

  /// Takes the latency of one scan [ms].
  void add_latency(double milliseconds) { latencies_.add(milliseconds); }
  /// Percentile of the newest latencies [ms]; share in [0, 1].
  double latency(double share) const { return latencies_.percentile(share); }
  /// Whether these bytes are one of the newest messages that were sent here, and come back for the first
  /// time: a link brings each of our own back once. What comes again, word by word, is a twin's.
  bool take_own(std::span<const std::uint8_t> bytes);
  /// Sends the figures with the latencies; `last_error` is for people's eyes.
  void publish(const NodeFigures& figures, const std::string& last_error);

 private:
  Bus& bus_;
  std::string channel_, node_;
  std::int32_t node_id_;
  LatencyWindow latencies_;
  static constexpr std::size_t kRemembered = 16;                ///< Messages.
  std::array<std::optional<std::size_t>, kRemembered> sent_{};  ///< Hashes of those not back yet, a ring.
  std::size_t num_sent_ = 0;
};

/// The node_id of a status message, bytes 16 to 19, read without decoding the rest, whose strings are not to
/// be trusted; nothing where the message is too short.
std::optional<std::int32_t> status_node_id(std::span<const std::uint8_t> bytes);

}  // namespace lookout::lcmtypes
