#pragma once

#include <cstdint>
#include <map>

#include "fusion/local_track_store.hpp"

namespace lookout::fusion {

/// Who else speaks for a global track when a local one is paired with it.
enum class Company {
  none,       ///< No other node.
  newcomers,  ///< Other nodes, from this very time on.
  voices      ///< Other nodes did so the last time already.
};

/// Which global track each local one goes with, and since when. A newcomer to a track that another node
/// speaks for is on probation: it is paired, but not trusted until so many of its messages in a row
/// have been paired with the same track. A tracker that has just started guesses at first, and where targets
/// meet a wrong guess would draw the track to the wrong one and thereby confirm itself. Nodes that bring a
/// track up together all have a vote at once, else it would be one node's for that long.
class Pairings {
 public:
  using Key = LocalTrackStore::Key;

  /// @param probation messages, >= 1.
  explicit Pairings(int probation) : probation_(static_cast<std::size_t>(probation)) {}

  /// Pairs `local` with a global track. @return whether `local` has a vote there.
  bool pair(const LocalTrack& local, std::int64_t global_id, Company company);

  /// The global track that `local` was paired with the last time; -1: none.
  std::int64_t global_of(const Key& local) const;
  /// The same where `local` is trusted there and has not begun again since; else -1.
  std::int64_t trusted_in(const LocalTrack& local) const;

  /// Two global tracks have become one.
  void rename(std::int64_t ended, std::int64_t kept);
  /// Forgets local tracks that the store has forgotten.
  void forget_unknown(const LocalTrackStore::Tracks& known);
  void clear() { pairings_.clear(); }  ///< Forgets every pairing.

 private:
  struct Pairing {
    std::int64_t global_id = -1;
    std::size_t since = 0;  ///< Messages that the local track had sent when they were paired.
    std::size_t heard = 0;  ///< The same at the newest pairing.
    bool votes = false;
    bool trusted = false;
  };

  std::size_t probation_;
  std::map<Key, Pairing> pairings_;
};

}  // namespace lookout::fusion
