#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/pose_history.hpp"
#include "core/sequence_gaps.hpp"
#include "core/sonar_image.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "tracking/intake/clock_guard.hpp"

namespace lookout::tracking {

/// How long and how many pings wait for their pose.
struct IntakeParams {
  std::int64_t max_wait = 1'000'000;  ///< How long a ping waits for its pose, in data time [us], >= 0.
  std::size_t max_waiting = 256;      ///< Pings that may wait at once, >= 1; bounds memory in a flood.
  ClockGuardParams clock;             ///< Which stamps are believed.
};

/// What became of everything that came in since the start.
struct IntakeCounts {
  std::int64_t accepted = 0;         ///< Pings handed out.
  std::int64_t no_pose = 0;          ///< Pings without vehicle states on either side.
  std::int64_t damaged = 0;          ///< Pings with a damaged header, wrong sizes or NaN.
  std::int64_t out_of_time = 0;      ///< Pings that repeat, go back or jump ahead in time.
  std::int64_t lost = 0;             ///< Pings missing by their sequence.
  std::int64_t restarts = 0;         ///< Times that the sequence went backwards.
  std::int64_t resets = 0;           ///< New clocks.
  std::int64_t dropped_returns = 0;  ///< Returns out of bounds, of accepted pings.
  std::int64_t other_geometry = 0;   ///< Accepted pings whose geometry is not the configured one.
  std::int64_t bad_states = 0;       ///< Vehicle states damaged or out of time.

  std::int64_t rejected() const { return no_pose + damaged + out_of_time; }  ///< All that were refused.
};

template <class Ping>
struct PosedOf;
template <>
struct PosedOf<core::SonarScan> {
  using Type = core::PosedScan;
};
template <>
struct PosedOf<core::SonarImage> {
  using Type = core::PosedImage;
};

/// Takes vehicle states and pings in the order of their arrival and hands the pings out in order of time,
/// each with where the sonar was. The rules are those of docs/live.md: the same for a live
/// link, a log and a recording, so that all three give the same tracks. Bad input is rejected, counted and
/// reported, never thrown.
template <class Ping>
class PingIntake {
 public:
  using Posed = typename PosedOf<Ping>::Type;

  /// Who is told. All three must be set.
  struct Sink {
    std::function<void(const Posed&)> accept;  ///< The next ping; later than all before it, until a reset.
    std::function<void()> reset;               ///< A new clock begins: forget everything.
    std::function<void(const std::string&)> report;  ///< One line for a person.
  };

  /// @param configured geometry; that of a message wins, a disagreement is counted and reported.
  /// @throws std::invalid_argument on params out of range.
  PingIntake(const core::SonarParams& configured, Sink sink, const IntakeParams& params = {});

  /// Takes a vehicle state; hands on the pings that waited for it.
  void add(const core::VehicleState& state);
  void add(Ping ping);  ///< Takes a ping; hands it on at once where its pose is known.
  void finish();        ///< There is no more: what still waits for a pose will not get one.

  const IntakeCounts& counts() const { return counts_; }  ///< Since the start.
  std::int64_t newest_utime() const;  ///< Of the data that was believed [us]; 0 before any.

 private:
  void hand_out_what_has_a_pose();
  void hand_out(const core::Pose2& T_earth_body);
  void begin_new_clock(std::int64_t utime);
  void count_sequence(std::int64_t sequence);
  void reject(const Ping& ping, std::string_view reason, std::int64_t& count);
  void report_state(const core::VehicleState& state, std::string_view reason);

  core::SonarParams configured_;
  Sink sink_;
  IntakeParams params_;
  ClockGuard state_clock_, ping_clock_;
  core::PoseHistory poses_;
  core::PoseHistory suspect_poses_;  ///< On a clock that is not believed yet.
  core::SequenceGaps sequence_;
  std::deque<Ping> waiting_;
  Posed posed_;
  IntakeCounts counts_;
};

extern template class PingIntake<core::SonarScan>;
extern template class PingIntake<core::SonarImage>;

using ScanIntake = PingIntake<core::SonarScan>;
using ImageIntake = PingIntake<core::SonarImage>;

}  // namespace lookout::tracking
