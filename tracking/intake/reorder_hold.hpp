#pragma once

#include <algorithm>
#include <cstdint>

namespace lookout::tracking {

/// How long the pings of a stream are held back so that late ones can take their place: not at all while they
/// come in order; as long as the latest one was late, once one was too late; no more after a while without.
class ReorderHold {
 public:
  /// @param longest the hold never exceeds it [us].
  explicit ReorderHold(std::int64_t longest) : longest_(longest) {}

  /// A ping came out of order, `lateness` [us] behind the newest data, whose time is `now` [us].
  /// @param too_late those after it had been handed out.
  void note(std::int64_t lateness, std::int64_t now, bool too_late) {
    last_late_ = now;
    if (too_late && lateness <= longest_) hold_ = std::max(hold_, lateness);
  }

  /// How far the stream must have gone beyond a ping before it is handed out [us].
  std::int64_t at(std::int64_t now) const { return now - last_late_ <= kMemory ? hold_ : 0; }

  void forget() { hold_ = 0; }  ///< Holds nothing back.

 private:
  static constexpr std::int64_t kMemory =
      60'000'000;  ///< How long the lateness of a stream is remembered [us].
  std::int64_t longest_;
  std::int64_t hold_ = 0;
  std::int64_t last_late_ = 0;
};

}  // namespace lookout::tracking
