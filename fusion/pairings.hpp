#pragma once

#include <cstdint>
#include <map>

#include "fusion/local_track_store.hpp"

namespace lookout::fusion {

/// Which global track each local one goes with, and since when. A newcomer to a track that another node
/// already speaks for is on probation: it is paired, but has no vote until so many of its messages in a row
/// have been paired with the same track. A tracker that has just started guesses at first, and where targets
/// meet a wrong guess would draw the track to the wrong one and thereby confirm itself.
class Pairings {
 public:
  using Key = LocalTrackStore::Key;

  /// @param probation messages, >= 1.
  explicit Pairings(int probation) : probation_(static_cast<std::size_t>(probation)) {}

  /// Pairs `local` with a global track. @param must_prove another node speaks for that track already.
  /// @return whether `local` has a vote there.
  bool pair(const LocalTrack& local, std::int64_t global_id, bool must_prove);

  /// The global track that `local` was paired with the last time; -1: none.
  std::int64_t global_of(const Key& local) const;
  /// The same where `local` has a vote there and has not begun again since; else -1.
  std::int64_t voted_for(const LocalTrack& local) const;

  /// Two global tracks have become one.
  void rename(std::int64_t ended, std::int64_t kept);
  /// Forgets local tracks that the store has forgotten.
  void forget_unknown(const LocalTrackStore::Tracks& known);
  void clear() { pairings_.clear(); }

 private:
  struct Pairing {
    std::int64_t global_id = -1;
    std::size_t since = 0;  ///< Messages that the local track had sent when they were paired.
    std::size_t heard = 0;  ///< The same at the newest pairing.
    bool votes = false;
  };

  std::size_t probation_;
  std::map<Key, Pairing> pairings_;
};

}  // namespace lookout::fusion
