#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/sequence_gaps.hpp"
#include "core/sonar_params.hpp"
#include "tracking/intake/fan_finder.hpp"
#include "tracking/intake/intake_counts.hpp"
#include "tracking/intake/outside_returns.hpp"
#include "tracking/intake/ping_checks.hpp"
#include "tracking/intake/ring_down.hpp"
#include "tracking/intake/sender_guard.hpp"
#include "tracking/intake/unit_guard.hpp"

namespace lookout::tracking {

/// What the sensors of an intake are counted in together, and who is told.
struct IntakeLedger {
  IntakeCounts counts;                             ///< Since the start.
  std::int64_t gaps = 0;                           ///< Times that numbers were missing.
  std::function<void(const std::string&)> report;  ///< One line for a person; must be set.
};

/// Watches the pings of one sensor for what a sound one does not do: numbers that are missing, go back or
/// come from two senders, a geometry other than the configured one, content that repeats, returns outside.
/// All but the clock, which `ClockGuard` watches. A Ping is a scan or an image.
class SensorGuards {
 public:
  /// @param configured geometry. Both must outlive it.
  SensorGuards(const core::SonarParams& configured, IntakeLedger& ledger)
      : configured_(&configured), ledger_(&ledger), units_(configured.scan_period) {}

  /// Of the next ping in the order of arrival: whether its number is another sender's. A ping that comes
  /// again, late, is its own sender's. @param utime of it [us].
  bool is_foreign(std::int64_t sequence, std::int64_t utime);
  /// The number of a ping whose turn it is, in order of time; counts and tells loss and restarts.
  void number_comes(std::int64_t sequence);
  void number_is_refused(std::int64_t sequence);  ///< That of a ping which will have no turn: it is not lost.

  /// Tells of stamps in another unit, of the next ping in the order of arrival.
  template <class Ping>
  void watch_pace(const Ping& ping);
  /// Tells of a geometry that is not the configured one.
  template <class Ping>
  void look_at(const Ping& ping);
  /// Whether the sensor repeats itself: it says nothing, and whoever learns from it learns wrong. The first
  /// repeat may be chance; all are counted and told.
  template <class Ping>
  bool is_frozen(const Ping& ping);
  /// Gives a scan the fan that its message could not carry, and takes silences and returns out of bounds out.
  template <class Ping>
  DroppedReturns drop_returns_of(Ping& ping);
  /// Takes out of a ping that is accepted what the transducer's own ring-down is, and of a crowded scan what
  /// is too much; counts and tells both.
  template <class Ping>
  void leave_out(Ping& ping);
  /// Why a ping contradicts its own geometry, empty for not. @param all returns of it. @param utime [us].
  std::string_view contradiction(const DroppedReturns& dropped, int all, std::int64_t utime);

  void begin_new_clock();  ///< Numbers and content start again.

 private:
  template <class Ping>
  void watch_ranges(const Ping& ping);

  static constexpr std::size_t kRemembered = 256;  ///< Pings that a double is known by.
  static constexpr std::int64_t kChangesTold = 8;  ///< Of a geometry, each; then the 16th, 32nd, ...
  struct Heard {
    std::int64_t sequence = 0, utime = 0;
    bool operator==(const Heard&) const = default;
  };

  const core::SonarParams* configured_;
  IntakeLedger* ledger_;
  core::SequenceGaps gaps_;
  SenderGuard sender_;
  std::array<Heard, kRemembered> heard_{};  ///< A ring.
  std::size_t num_heard_ = 0;
  OutsideReturns outside_;
  std::optional<PingGeometry> geometry_;
  std::int64_t same_ranges_ = 0;  ///< Pings of which most returns have one range.
  std::int64_t changes_ = 0;      ///< Times that the geometry became another, not the configured one.
  FanFinder fan_;
  UnitGuard units_;
  RingDown ring_;
  std::vector<char> beams_heard_;
  std::size_t content_ = 0;  ///< Of the last ping, as a hash; 0 for too little to tell.
  int repeats_ = 0;          ///< Pings in a row with that content, beyond the first.
};

}  // namespace lookout::tracking
