#include "tools/fault/wire_message.hpp"

#include "lcmtypes/convert.hpp"
#include "lcmtypes/inbox.hpp"

namespace lookout::tools {
namespace {

template <class Wire>
std::vector<std::uint8_t> encoded(const Wire& wire) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(wire.getEncodedSize()));
  wire.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

template <class Wire>
void read_content(std::span<const std::uint8_t> bytes, FaultMessage& message) {
  const auto wire = lcmtypes::decode<Wire>(bytes.data(), bytes.size());
  if (!wire) return;
  auto converted = lcmtypes::to_core(*wire);
  if (!converted.value) return;
  message.utime = converted.value->utime;
  message.content = *std::move(converted.value);
}

}  // namespace

FaultMessage read_message(Stream stream, std::span<const std::uint8_t> bytes, std::int64_t fallback_utime) {
  FaultMessage message{stream, fallback_utime, {}, {bytes.begin(), bytes.end()}, false};
  if (stream == Stream::vehicle) read_content<vehicle_state_t>(bytes, message);
  if (stream == Stream::scan) read_content<sonar_scan_t>(bytes, message);
  return message;
}

std::vector<std::uint8_t> wire_bytes(const FaultMessage& message) {
  if (!message.goes_by_content()) return message.bytes;
  if (const auto* state = std::get_if<core::VehicleState>(&message.content))
    return encoded(lcmtypes::to_wire(*state));
  return encoded(lcmtypes::to_wire(std::get<core::SonarScan>(message.content)));
}

}  // namespace lookout::tools
