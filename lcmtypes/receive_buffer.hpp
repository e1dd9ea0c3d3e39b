#pragma once

#include <cstdint>
#include <optional>
#include <string>

/// The receive buffer of a UDP socket: what comes while the program is at work waits in it, and what finds no
/// room is dropped by the system. A message of several datagrams is lost with any one of them.
namespace lookout::lcmtypes {

/// The largest buffer that the system grants without privileges [bytes] (net.core.rmem_max); nothing where it
/// does not say.
std::optional<std::int64_t> largest_receive_buffer();

/// What is asked for where the system grants more [bytes]: two of the largest images.
inline constexpr std::int64_t kWantedReceiveBuffer = std::int64_t{16} << 20;

/// A udpm address that asks LCM for as large a buffer as there may be, up to kWantedReceiveBuffer. Another
/// transport, an address that says recv_buf_size itself, or a system that does not say what it grants: as it
/// was.
std::string with_receive_buffer(const std::string& url, std::optional<std::int64_t> largest);

/// Datagrams that found no room in the buffers of this process's open UDP sockets since each was opened.
std::int64_t dropped_datagrams();

}  // namespace lookout::lcmtypes
