#pragma once

#include <cstdint>
#include <optional>

namespace lookout::tracking {

/// Tells two senders apart that speak under one `sensor_id`, by their numbers: two lines of numbers that
/// take turns are two senders, and the one that was there first is believed as long as it goes on. A line
/// that is left and never taken up again is one sender whose numbers jumped.
class SenderGuard {
 public:
  static constexpr std::uint64_t kNear = 8;  ///< Numbers no farther apart are of one line: loss, late pings.
  static constexpr int kShown = 3;  ///< Turns in a row that show two senders; one is a damaged number.
  static constexpr int kGone = 8;   ///< Pings of the other, without any of its own, that end a line.

  /// Takes the next number in the order of arrival; whether it is another sender's.
  bool is_foreign(std::int64_t sequence);

 private:
  std::optional<std::int64_t> own_, other_;  ///< The newest number of either line.
  int turns_ = 0;                            ///< Times in a row that the own line went on after the other.
  int others_ = 0;                           ///< Pings of the other line since the newest own one.
};

}  // namespace lookout::tracking
