#pragma once

#include <cstdint>
#include <optional>

namespace lookout::tracking {

/// When a time is believed.
struct ClockGuardParams {
  /// Farthest step ahead that is still the same clock [us], > 0. Longer than any tracker remembers, so that a
  /// reset after a pause forgets nothing that is worth keeping.
  std::int64_t max_step = 60'000'000;
  int new_clock_after = 5;  ///< Consistent times on another clock after which that one is believed, >= 1.
};

/// Judges the times of one stream. A time that repeats, goes back or jumps ahead is suspect; when as many
/// suspects in a row as `new_clock_after` follow one another, the stream is on a new clock.
class ClockGuard {
 public:
  /// The stamp is believed, it is not, or the last ones in a row make a new clock.
  enum class Verdict { in_order, suspect, new_clock };

  /// @throws std::invalid_argument on params out of range.
  explicit ClockGuard(const ClockGuardParams& params = {});

  Verdict judge(std::int64_t utime);  ///< Judges the stamp of the next message [us].

  std::optional<std::int64_t> last() const { return last_; }  ///< Newest time on the believed clock [us].
  int suspects() const { return num_suspects_; }              ///< In a row, the newest among them.

  /// Believes the suspects' clock at once if its newest time is near `utime`. Returns whether it does.
  bool adopt_suspects_near(std::int64_t utime);

 private:
  bool follows(std::int64_t before, std::int64_t utime) const;

  ClockGuardParams params_;
  std::optional<std::int64_t> last_;
  std::int64_t newest_suspect_ = 0;
  int num_suspects_ = 0;
};

}  // namespace lookout::tracking
