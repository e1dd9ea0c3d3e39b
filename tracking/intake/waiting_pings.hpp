#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <iterator>
#include <utility>

#include "tracking/intake/ping_content.hpp"

namespace lookout::tracking {

/// The pings of all sensors that wait for their pose, in order of time; of one time in order of arrival.
template <class Ping>
class WaitingPings {
 public:
  bool empty() const { return pings_.empty(); }                      ///< Whether none waits.
  std::size_t size() const { return pings_.size(); }                 ///< How many wait.
  std::size_t bytes() const { return bytes_; }                       ///< What they heard, altogether.
  std::int64_t first_utime() const { return pings_.front().utime; }  ///< [us]; of one at least.
  std::int64_t last_utime() const { return pings_.back().utime; }    ///< [us]; of one at least.

  /// Puts a ping in its place, unless its sensor has one of that time among them: then it is left as it is.
  /// @return whether it waits now.
  bool insert(Ping& ping) {
    const auto place =
        std::upper_bound(pings_.begin(), pings_.end(), ping.utime,
                         [](std::int64_t time, const Ping& other) { return time < other.utime; });
    for (auto other = place; other != pings_.begin() && std::prev(other)->utime == ping.utime; --other)
      if (std::prev(other)->sensor_id == ping.sensor_id) return false;
    bytes_ += content_of(ping).size();
    pings_.insert(place, std::move(ping));
    return true;
  }

  /// Takes the first of one at least.
  Ping take_first() {
    Ping first = std::move(pings_.front());
    pings_.pop_front();
    bytes_ -= content_of(first).size();
    return first;
  }

 private:
  std::deque<Ping> pings_;
  std::size_t bytes_ = 0;
};

}  // namespace lookout::tracking
