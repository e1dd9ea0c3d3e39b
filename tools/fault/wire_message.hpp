#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tools/fault/fault_message.hpp"

/// Messages of a fault line as they travel.
namespace lookout::tools {

/// The message of these bytes. What cannot be read, and every image, is its bytes alone.
/// @param fallback_utime when it was sent, where the bytes do not say [us].
FaultMessage read_message(Stream stream, std::span<const std::uint8_t> bytes, std::int64_t fallback_utime);

/// What goes over the wire. @throws std::length_error for content that does not fit a datagram.
std::vector<std::uint8_t> wire_bytes(const FaultMessage& message);

}  // namespace lookout::tools
