#pragma once

#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <string>
#include <vector>

namespace lookout::tests {

/// Appends a wire message to a log as lcm-logger does, with `utime` [us] as its time of arrival.
template <class Wire>
void log_message(lcm::LogFile& file, const std::string& channel, const Wire& wire, std::int64_t utime = 0) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(wire.getEncodedSize()));
  wire.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  lcm::LogEvent event{};
  event.timestamp = utime;
  event.channel = channel;
  event.datalen = static_cast<int>(bytes.size());
  event.data = bytes.data();
  file.writeEvent(&event);
}

}  // namespace lookout::tests
