#include "lcmtypes/status_board.hpp"

#include <lookout/node_status_t.hpp>

namespace lookout::lcmtypes {

StatusBoard::StatusBoard(Bus& bus, std::string channel, std::string node, std::int32_t node_id)
    : bus_(bus), channel_(std::move(channel)), node_(std::move(node)), node_id_(node_id) {}

void StatusBoard::publish(const NodeFigures& figures, const std::string& last_error) {
  node_status_t wire{};
  wire.utime = figures.utime;
  wire.node_id = node_id_;
  wire.accepted = figures.accepted;
  wire.rejected = figures.rejected;
  wire.dropped = figures.dropped;
  wire.shed = figures.shed;
  wire.send_errors = bus_.send_errors();
  wire.latency_ms_p50 = latencies_.percentile(0.50);
  wire.latency_ms_p99 = latencies_.percentile(0.99);
  wire.latency_ms_max = latencies_.percentile(1.0);
  wire.node = node_;
  wire.last_error = last_error;
  bus_.publish(channel_, wire);
}

std::optional<std::int32_t> status_node_id(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kBegin = 16;
  if (bytes.size() < kBegin + sizeof(std::int32_t)) return std::nullopt;
  std::uint32_t value = 0;
  for (std::size_t i = kBegin; i < kBegin + sizeof(value); ++i) value = value << 8U | bytes[i];
  return static_cast<std::int32_t>(value);
}

}  // namespace lookout::lcmtypes
