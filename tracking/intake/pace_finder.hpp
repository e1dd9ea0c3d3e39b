#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

namespace lookout::tracking {

/// Finds how often the sensors of a stream ping. A message carries no period, and what a tracker waits for
/// and remembers follows from it: told half a second, it finds nothing in scans six seconds apart.
///
/// A stream that is faster than was configured changes nothing: lengths are times, of which more scans only
/// show more.
class PaceFinder {
 public:
  static constexpr std::size_t kFewest = 4;      ///< Steps that show a pace.
  static constexpr std::size_t kSteps = 8;       ///< That are looked at: fewer follow every uneven stamp.
  static constexpr double kOff = 1.4;            ///< Times that a pace must be off the one in use.
  static constexpr std::int64_t kMostLost = 16;  ///< Pings between two that a step may span.

  /// @param scan_period that is configured [s], > 0; in use at first.
  explicit PaceFinder(double scan_period) : configured_(scan_period), in_use_(scan_period) {}

  /// What of a ping says when it was made.
  struct Ping {
    std::int32_t sensor_id = 0;  ///< Who made it.
    std::int64_t sequence =
        0;                   ///< Lost pings are known by it; a driver may count none, in tens or backwards.
    std::int64_t utime = 0;  ///< [us].
  };
  /// Takes the next accepted ping, in order of time. @return the period that is in use from now on [s], where
  /// it becomes another: the middle one of the newest steps, of the fastest sensor that still pings, but none
  /// below the configured one.
  std::optional<double> learn(const Ping& ping);

  /// A ping of this sensor was left out on purpose: the step across it says nothing.
  void skip(std::int32_t sensor_id);
  void begin_new_clock() { streams_.clear(); }  ///< The next ping makes no step. What is in use stays.

 private:
  /// From one ping to the next.
  struct Step {
    double seconds = 0.0;
    std::int64_t numbers = 0;  ///< By which the sequence went on.
  };
  /// The pings of one sensor.
  struct Stream {
    Ping last;
    std::array<Step, kSteps> steps{};  ///< A ring.
    std::size_t count = 0;             ///< Steps so far.
    bool has_gap = false;              ///< Pings were left out since the last.
  };

  static std::optional<double> middle(const Stream& stream);
  void forget_slower_than(double step, std::int64_t utime);
  std::optional<double> pace() const;

  double configured_, in_use_;
  std::map<std::int32_t, Stream> streams_;
};

}  // namespace lookout::tracking
