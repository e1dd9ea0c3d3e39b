#pragma once

#include <cstdint>
#include <deque>

#include "lcmtypes/convert.hpp"

namespace lookout::tools {

/// Where the tracks were in the last 30 s of data time, thinned and bounded.
class TrackTrails {
 public:
  static constexpr std::int64_t kMemory = 30'000'000;  ///< [us] of data time.
  static constexpr std::int64_t kSpacing = 450'000;    ///< Lists nearer than that [us] replace the newest.

  void add(const lcmtypes::KeyedTracks& tracks);
  const std::deque<lcmtypes::KeyedTracks>& lists() const { return lists_; }  ///< Oldest first.

 private:
  std::deque<lcmtypes::KeyedTracks> lists_;
};

}  // namespace lookout::tools
