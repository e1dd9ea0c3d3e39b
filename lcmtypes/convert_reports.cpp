#include "lcmtypes/convert_reports.hpp"

#include <algorithm>
#include <cassert>
#include <lookout/node_status_t.hpp>
#include <lookout/ospa_t.hpp>
#include <vector>

#include "lcmtypes/inbox.hpp"
#include "lcmtypes/wire_checks.hpp"

namespace lookout::lcmtypes {
namespace {

constexpr std::size_t kLengthBytes = 4;  // Of LCM's strings: big-endian, the closing NUL counted.

char printable(std::uint8_t byte) {
  constexpr std::uint8_t kFirst = 0x20, kLast = 0x7e;
  return byte >= kFirst && byte <= kLast ? static_cast<char>(byte) : '?';
}

/// Takes one string off the front of `bytes`; nothing where it does not lie within them.
std::optional<std::string> take_text(std::span<const std::uint8_t>& bytes) {
  if (bytes.size() < kLengthBytes) return std::nullopt;
  std::uint32_t length = 0;
  for (const std::uint8_t byte : bytes.first(kLengthBytes)) length = length << 8U | byte;
  bytes = bytes.subspan(kLengthBytes);
  if (length < 1 || length > bytes.size() || bytes[length - 1] != 0) return std::nullopt;
  std::string text;
  for (const std::uint8_t byte : bytes.first(std::min<std::size_t>(length - 1, kMaxShownText)))
    text += printable(byte);
  bytes = bytes.subspan(length);
  return text;
}

/// Bytes of a status message before its strings, which stand last.
std::size_t bytes_before_texts() {
  const node_status_t empty{};
  return static_cast<std::size_t>(empty.getEncodedSize()) - 2 * (kLengthBytes + 1);
}

/// The figures alone, decoded with two empty strings in the place of those that came.
std::optional<node_status_t> decode_figures(std::span<const std::uint8_t> figures) {
  std::vector<std::uint8_t> whole(figures.begin(), figures.end());
  for (int text = 0; text < 2; ++text) whole.insert(whole.end(), {0, 0, 0, 1, 0});
  return decode<node_status_t>(whole.data(), whole.size());
}

}  // namespace

std::optional<NodeStatus> read_node_status(std::span<const std::uint8_t> bytes) {
  const std::size_t fixed = bytes_before_texts();
  if (bytes.size() < fixed) return std::nullopt;
  const auto wire = decode_figures(bytes.first(fixed));
  auto rest = bytes.subspan(fixed);
  const auto node = take_text(rest);
  const auto last_error = node ? take_text(rest) : std::nullopt;
  if (!wire || !last_error || !rest.empty()) return std::nullopt;
  if (!is_time(wire->utime) || !all_finite({wire->latency_ms_p50, wire->latency_ms_p99})) return std::nullopt;
  return NodeStatus{wire->utime,          wire->node_id,        wire->accepted, wire->rejected, wire->dropped,
                    wire->latency_ms_p50, wire->latency_ms_p99, *node,          *last_error};
}

std::optional<OspaReport> read_ospa(std::span<const std::uint8_t> bytes) {
  const auto wire = decode<ospa_t>(bytes.data(), bytes.size());
  if (!wire || !is_time(wire->utime) || wire->num_truth < 0 || wire->num_tracks < 0) return std::nullopt;
  if (!all_finite({wire->cutoff, wire->order, wire->total, wire->localization, wire->cardinality}))
    return std::nullopt;
  return OspaReport{wire->utime,        wire->cutoff,      wire->order,     wire->total,
                    wire->localization, wire->cardinality, wire->num_truth, wire->num_tracks};
}

decisions_t to_wire(const DecisionReport& report) {
  assert(report.text.size() <= kMaxDecisionText);
  decisions_t wire{};
  wire.utime = report.utime;
  wire.sequence = report.sequence;
  wire.source_id = report.source_id;
  wire.num_characters = static_cast<std::int16_t>(report.text.size());
  wire.text.assign(report.text.begin(), report.text.end());
  return wire;
}

std::optional<DecisionReport> read_decisions(std::span<const std::uint8_t> bytes) {
  const auto wire = decode<decisions_t>(bytes.data(), bytes.size());
  if (!wire || !is_time(wire->utime) || !agrees(wire->num_characters, wire->text.size())) return std::nullopt;
  if (wire->text.size() > kMaxDecisionText) return std::nullopt;
  DecisionReport report{wire->utime, wire->sequence, wire->source_id, {}};
  for (const std::uint8_t byte : wire->text) report.text += byte == '\n' ? '\n' : printable(byte);
  return report;
}

}  // namespace lookout::lcmtypes
