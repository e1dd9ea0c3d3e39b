#pragma once

#include <cstdint>
#include <lookout/decisions_t.hpp>
#include <optional>
#include <span>
#include <string>

/// What nodes report for people's eyes, LOOKOUT_STATUS, OSPA and DECISIONS, read for showing it and for
/// nothing else.
namespace lookout::lcmtypes {

/// A LOOKOUT_STATUS message.
struct NodeStatus {
  std::int64_t utime = 0;       ///< Of the newest data, scenario time [us].
  std::int32_t node_id = 0;     ///< Of a vehicle's tracker; 0 of sim, score and fuse.
  std::int64_t accepted = 0;    ///< Scans taken since the start.
  std::int64_t rejected = 0;    ///< Messages refused since the start.
  std::int64_t dropped = 0;     ///< Scans lost on the way since the start.
  double latency_ms_p50 = 0.0;  ///< [ms].
  double latency_ms_p99 = 0.0;  ///< [ms].
  std::string node;             ///< Which program; at most kMaxShownText printable characters.
  std::string last_error;       ///< Its newest refusal; likewise.
};

inline constexpr std::size_t kMaxShownText = 200;  ///< Characters of a text from outside that are kept.

/// The message, or nothing where it is damaged. The generated decoder never sees the strings, whose lengths
/// it does not check: they are read here within the message's bounds, and what is not printable becomes `?`.
std::optional<NodeStatus> read_node_status(std::span<const std::uint8_t> bytes);

/// An OSPA message.
struct OspaReport {
  std::int64_t utime = 0;     ///< Of the scan [us].
  double cutoff = 0.0;        ///< [m].
  double order = 0.0;         ///< Of the metric.
  double total = 0.0;         ///< [m].
  double localization = 0.0;  ///< [m].
  double cardinality = 0.0;   ///< [m].
  int num_truth = 0;          ///< Targets that count.
  int num_tracks = 0;         ///< Tracks that count.
};

/// The message, or nothing where it is damaged.
std::optional<OspaReport> read_ospa(std::span<const std::uint8_t> bytes);

/// A DECISIONS message.
struct DecisionReport {
  std::int64_t utime = 0;      ///< Of the scan [us].
  std::int64_t sequence = 0;   ///< Of the scan.
  std::int32_t source_id = 0;  ///< The tracker's node_id.
  std::string text;  ///< Lines, each with a line feed behind it; at most kMaxDecisionText characters.
};

inline constexpr std::size_t kMaxDecisionText =
    30'000;  ///< Characters of a message, which counts in 16 bits.

/// The message. Asks that the text is not above kMaxDecisionText.
decisions_t to_wire(const DecisionReport& report);

/// The message, or nothing where it is damaged. What is neither printable nor a line feed becomes `?`.
std::optional<DecisionReport> read_decisions(std::span<const std::uint8_t> bytes);

}  // namespace lookout::lcmtypes
