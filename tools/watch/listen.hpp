#pragma once

#include "lcmtypes/bus.hpp"
#include "tools/watch/heard.hpp"

namespace lookout::tools {

/// Subscribes to all that is watched; nothing is ever published. `heard` must outlive the bus's handling.
inline void listen(lcmtypes::Bus& bus, Heard& heard) {
  for (const auto& channel : heard.channel_names())
    bus.subscribe_bytes(channel, [&heard, channel](std::span<const std::uint8_t> bytes) {
      heard.take(channel, bytes, Heard::Clock::now());
    });
}

}  // namespace lookout::tools
