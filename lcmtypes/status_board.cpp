#include "lcmtypes/status_board.hpp"

#include <algorithm>
#include <functional>
#include <lookout/node_status_t.hpp>
#include <string_view>
#include <vector>

namespace lookout::lcmtypes {
namespace {

std::size_t hash_of(std::span<const std::uint8_t> bytes) {
  return std::hash<std::string_view>()({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::vector<std::uint8_t> encoded(const node_status_t& wire) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(wire.getEncodedSize()));
  wire.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

}  // namespace

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
  sent_[num_sent_++ % kRemembered] = hash_of(encoded(wire));
  bus_.publish(channel_, wire);
}

bool StatusBoard::take_own(std::span<const std::uint8_t> bytes) {
  const auto found = std::find(sent_.begin(), sent_.end(), hash_of(bytes));
  if (found == sent_.end()) return false;
  found->reset();
  return true;
}

std::optional<std::int32_t> status_node_id(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kBegin = 16;
  if (bytes.size() < kBegin + sizeof(std::int32_t)) return std::nullopt;
  std::uint32_t value = 0;
  for (std::size_t i = kBegin; i < kBegin + sizeof(value); ++i) value = value << 8U | bytes[i];
  return static_cast<std::int32_t>(value);
}

}  // namespace lookout::lcmtypes
