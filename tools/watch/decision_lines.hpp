#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lookout::tools {

/// A line that a tracker's --explain wrote about a track.
struct DecisionLine {
  double time_s = std::numeric_limits<double>::quiet_NaN();  ///< Data time [s]; NaN where it cannot be read.
  std::string text;                                          ///< From the time on, at most 300 characters.
};

inline constexpr std::size_t kMostDecisionLines = 200;  ///< Of one track that are kept.

/// The track that a line is about, and the line; nothing of another line.
std::optional<std::pair<std::int64_t, DecisionLine>> parse_decision(const std::string& line);

/// The newest of the lines that a tracker's --explain wrote to `path` about one track, oldest first, at most
/// 200; empty where the file cannot be read.
/// @param longest_read of a longer file only so much of its end is looked at [bytes].
std::vector<DecisionLine> decision_lines(const std::string& path, std::int64_t track,
                                         std::int64_t longest_read = 1'000'000);

}  // namespace lookout::tools
