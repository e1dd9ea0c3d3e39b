#pragma once

#include <cstdint>
#include <optional>

namespace lookout::tracking {

/// Compares the stamps of a stream with the clock of who heard it. Whoever stamps in milliseconds has all
/// that moves go a thousand times too slow, which scans ten seconds apart hide: ten milliseconds are a pace
/// that a sonar may have. It doubts, and decides nothing: data is processed by its own times alone.
class StampClock {
 public:
  static constexpr int kSteps = 10;                 ///< That show it.
  static constexpr std::int64_t kSpan = 4'000'000;  ///< And the time that they take at least [us].
  static constexpr double kAlike = 2.0;             ///< A factor off by less is the unit's.

  /// Takes the next ping. @param utime its stamp [us]. @param heard when it came, on any steady clock [us].
  void add(std::int64_t utime, std::int64_t heard);

  /// By which factor, 1,000 or 1,000,000, the stamps go too slow; nothing for stamps of the right unit.
  std::optional<std::int64_t> slower() const;
  std::int64_t doubted() const { return doubted_; }  ///< Pings that came while that was so.

 private:
  std::optional<std::int64_t> utime_;  ///< Of the newest ping [us],
  std::int64_t heard_ = 0;             ///< and when it came [us].
  std::int64_t steps_ = 0, doubted_ = 0;
  double stamped_ = 0.0, passed_ = 0.0;  ///< In all steps [us].
};

}  // namespace lookout::tracking
