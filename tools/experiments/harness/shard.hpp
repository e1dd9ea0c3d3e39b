#pragma once

#include <cstddef>
#include <string>

namespace lookout::tools {

/// One of `count` parts of a study's work, that another process or machine may do.
struct Shard {
  int index = 1;  ///< In 1 .. count.
  int count = 1;  ///< 1: the whole.

  bool is_whole() const { return count == 1; }  ///< Whether there are no other parts.
  /// Whether task number `task`, counted from 0 over all of the study, belongs to this part.
  bool holds(std::size_t task) const {
    return task % static_cast<std::size_t>(count) == static_cast<std::size_t>(index - 1);
  }
  std::string text() const;  ///< "3/12".
};

/// The part that `--shard K/N` asks for; empty text: the whole.
/// @throws core::InputError on anything but 1 <= K <= N <= 100000.
Shard parse_shard(const std::string& text);

}  // namespace lookout::tools
