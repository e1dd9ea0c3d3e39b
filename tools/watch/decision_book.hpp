#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <string_view>
#include <vector>

#include "tools/watch/decision_lines.hpp"

namespace lookout::tools {

/// What trackers said of their decisions over the wire, by track. Bounded: the tracks that ended first are
/// forgotten first. May be used from several threads.
class DecisionBook {
 public:
  static constexpr std::size_t kMostTracks = 20'000;

  /// @param most_tracks that are remembered, > 0.
  explicit DecisionBook(std::size_t most_tracks = kMostTracks) : most_tracks_(most_tracks) {}

  /// Takes the lines of a message; a line that tells no decision is left out.
  void add(std::string_view lines);

  /// Those of one track, oldest first, at most kMostDecisionLines.
  std::vector<DecisionLine> of(std::int64_t track) const;

 private:
  void add_line(std::int64_t track, DecisionLine line);

  const std::size_t most_tracks_;
  mutable std::mutex mutex_;
  std::map<std::int64_t, std::deque<DecisionLine>> told_;
  std::deque<std::int64_t> ended_;  ///< In the order of their ends.
};

}  // namespace lookout::tools
