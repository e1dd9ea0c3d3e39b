#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lookout::tracking {

/// Notices figures of one sensor that are in another unit from its first ping on. Whoever stamps in
/// milliseconds lets a sonar of 2 Hz ping 2000 times a second and every target stand still; ranges in
/// millimetres lie all beyond the maximum, those in kilometres all at the sonar. Such a stream gives no
/// track, and only this says why. It doubts, and refuses nothing.
class UnitGuard {
 public:
  static constexpr double kPeriods = 100.0;         ///< Times too fast or too slow that a pace must be.
  static constexpr std::int64_t kFastest = 10'000;  ///< Steps below are too fast in any case [us]: sound
                                                    ///< goes to 7.5 m and back.
  static constexpr int kShown = 10;                 ///< Steps in a row that show it; fewer are a burst.
  static constexpr int kLooked = 20;     ///< Pings with returns after which their ranges are judged.
  static constexpr double kNear = 0.01;  ///< Share of the maximum range within which no sonar has them all.

  /// @param scan_period that is configured [s], > 0.
  explicit UnitGuard(double scan_period);

  /// What is doubted of a time.
  enum class Pace { plausible, too_fast, too_slow };
  /// Takes the time [us] of the next ping in the order of arrival. One that comes twice is no step.
  Pace judge_pace(std::int64_t utime);
  std::int64_t step() const { return step_; }  ///< The newest [us].

  /// The returns of a ping.
  struct Ranges {
    int all = 0;            ///< Without silences.
    int outside = 0;        ///< Of those, out of the beams or beyond the maximum.
    double farthest = 0.0;  ///< Of the others [m].
    double maximum = 0.0;   ///< The sonar's [m].
  };
  /// What is doubted of ranges, once, at the ping that completes the first `kLooked`; empty: nothing.
  std::string doubt_ranges(const Ranges& ranges);

  void begin_new_clock();  ///< The next ping makes no step from the one before.

 private:
  std::int64_t fast_, slow_;  ///< Steps below and above are odd [us].
  std::optional<std::int64_t> last_;
  std::int64_t step_ = 0;
  Pace pace_ = Pace::plausible;  ///< Of the newest step,
  int alike_ = 0;                ///< and how many in a row had it.
  int looked_ = 0;
  Ranges sum_;  ///< Counts of all pings that were looked at, and the farthest of them.
};

}  // namespace lookout::tracking
