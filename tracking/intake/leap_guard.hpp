#pragma once

#include <cstdint>
#include <optional>

namespace lookout::tracking {

/// What a quantity may leap by, in its own unit, and how long a leap is doubted.
struct LeapGuardParams {
  double leap = 1.0;                      ///< It may be off its line by so much, > 0 ...
  double rate = 0.0;                      ///< ... and by so much more a second since the time before, >= 0.
  std::int64_t longest_step = 2'000'000;  ///< After a longer silence nothing is known [us], > 0.
  double nearest = 0.5;  ///< Back within this share of the leap, in (0, 1), it is over. Own choice.
  std::int64_t patience = 20'000'000;  ///< After so long the new line is believed [us], >= 0 ...
  std::int64_t rest = 60'000'000;      ///< ... and no leap is doubted for so long [us], >= 0.
};

/// Doubts a quantity that leaps off its line until it is back. No longer than the line before lasted, so that
/// a start elsewhere is soon forgotten.
class LeapGuard {
 public:
  /// Knows no line yet.
  explicit LeapGuard(const LeapGuardParams& params) : params_(params) {}

  /// @param utime of the next value [us]; it may be a little late.
  /// @param off how far the value is from the believed line; of no meaning for the first.
  /// @return whether it is on another one, which is not believed.
  bool is_leap(std::int64_t utime, double off);

 private:
  /// A leap that is not believed.
  struct Leap {
    double size = 0.0;
    std::int64_t since = 0;  ///< Time of its first value [us].
  };

  bool is_off(std::int64_t utime, double off) const;
  bool is_over(std::int64_t utime) const;

  LeapGuardParams params_;
  std::optional<std::int64_t> newest_;  ///< Time of the newest value, believed or not [us].
  std::int64_t begin_ = 0;              ///< Since when the line is believed [us].
  std::optional<Leap> leap_;
  std::optional<std::int64_t> rest_until_;  ///< [us]
};

}  // namespace lookout::tracking
