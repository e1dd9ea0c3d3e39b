#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "lcmtypes/bus.hpp"
#include "lcmtypes/channels.hpp"
#include "lcmtypes/node_loop.hpp"
#include "lcmtypes/status_board.hpp"
#include "tools/fault/fault_line.hpp"

namespace lookout::tools {

/// Between which channels a relay stands.
struct FaultRelayParams {
  std::string from_prefix;  ///< Of the channels that are heard.
  std::string to_prefix;    ///< Of the channels that are spoken.
  std::uint64_t seed = 1;   ///< Of all draws.
};

/// VEHICLE_STATE, SONAR_SCAN, SONAR_IMAGE of one prefix -> FaultLine -> the same channels of another. What no
/// fault touches leaves to the byte as it came; GROUND_TRUTH passes so that a scorer may listen.
class FaultRelayNode {
 public:
  /// @param from, to the same bus, or two. @throws core::InputError where channels would feed themselves.
  FaultRelayNode(lcmtypes::Bus& from, lcmtypes::Bus& to, const FaultPlan& plan,
                 const FaultRelayParams& params);

  /// Relays until a limit is reached; then passes what is still held back.
  void run(const lcmtypes::LoopLimits& limits);

  FaultLine::Counts counts(Stream stream) const { return line_.counts(stream); }  ///< So far.

 private:
  void listen(Stream stream, const std::string& channel);
  void send(const FaultMessage& message);
  void publish_status();
  std::string channel_of(Stream stream) const;

  lcmtypes::Bus& from_;
  lcmtypes::Bus& to_;
  lcmtypes::Channels heard_, spoken_;
  FaultLine line_;
  lcmtypes::StatusBoard status_;
  std::int64_t newest_utime_ = 0;
};

}  // namespace lookout::tools
