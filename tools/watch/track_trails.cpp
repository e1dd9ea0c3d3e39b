#include "tools/watch/track_trails.hpp"

namespace lookout::tools {

void TrackTrails::add(const lcmtypes::KeyedTracks& tracks) {
  const std::int64_t now = tracks.key.utime;
  // A clock that went back, or far ahead, is a new one: what was belongs to another run.
  if (!lists_.empty() && (now < lists_.back().key.utime || now - lists_.back().key.utime > kMemory))
    lists_.clear();
  if (lists_.size() > 1 && now - lists_[lists_.size() - 2].key.utime < kSpacing) lists_.pop_back();
  lists_.push_back(tracks);
  while (now - lists_.front().key.utime > kMemory) lists_.pop_front();
}

}  // namespace lookout::tools
