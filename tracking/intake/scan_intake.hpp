#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/sonar_image.hpp"
#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "tracking/intake/clock_guard.hpp"
#include "tracking/intake/intake_counts.hpp"
#include "tracking/intake/pose_intake.hpp"
#include "tracking/intake/reorder_hold.hpp"
#include "tracking/intake/sensor_guards.hpp"
#include "tracking/intake/waiting_pings.hpp"

namespace lookout::tracking {

/// How long and how much an intake waits, and when it believes a time.
struct IntakeParams {
  /// How long a ping waits for its pose and for late pings before it, in data time [us], >= 0; where the
  /// sensor's params say something else than their default, that.
  std::int64_t max_wait = 1'000'000;
  std::size_t max_waiting = 1024;              ///< Pings that may wait at once, >= 1; with
  std::size_t max_waiting_bytes = 256U << 20;  ///< the room for their content they bound memory in a flood.
  ClockGuardParams clock;                      ///< `max_late` is taken from max_wait.
};

/// The posed form of a kind of ping.
template <class Ping>
struct PosedOf;
/// A scan's.
template <>
struct PosedOf<core::SonarScan> {
  using Type = core::PosedScan;  ///< With its pose.
};
/// An image's.
template <>
struct PosedOf<core::SonarImage> {
  using Type = core::PosedImage;  ///< With its pose.
};

/// Takes vehicle states and pings in the order of their arrival and hands the pings out in order of time,
/// each with where the sonar was. The rules are those of docs/live.md: the same for a live
/// link, a log and a recording, so that all three give the same tracks. Several sensors (`sensor_id`) share
/// it, each with its own clock, sequence and geometry. Bad input is rejected, counted and reported, never
/// thrown.
template <class Ping>
class PingIntake {
 public:
  using Posed = typename PosedOf<Ping>::Type;

  /// Who is told. The first three must be set; the others are for who keeps a recording of it.
  struct Sink {
    /// The next ping; not earlier than all before it and later than all of its sensor, until a reset.
    std::function<void(const Posed&)> accept;
    std::function<void()> reset;                     ///< A new clock begins: forget everything.
    std::function<void(const std::string&)> report;  ///< One line for a person.
    /// A state that is believed; `new_clock`: the first of a new clock, of which a `reset` may follow.
    std::function<void(const core::VehicleState&, bool new_clock)> believe = {};
    std::function<void(const core::Pose2& T_earth_body)> pose = {};  ///< Of the ping that is accepted next.
    /// What is wrong with a ping that would be accepted, by what is tracked; empty: nothing.
    std::function<std::string_view(const Posed&, const core::Pose2& T_earth_body)> doubt = {};
  };

  /// @param configured geometry; that of a message wins, a disagreement is counted and reported. Its
  /// `max_pose_gap` and `max_wait` hold.
  /// @throws std::invalid_argument on params out of range.
  PingIntake(const core::SonarParams& configured, Sink sink, const IntakeParams& params = {});
  PingIntake(const PingIntake&) = delete;
  PingIntake& operator=(const PingIntake&) = delete;

  void add(const core::VehicleState& state);  ///< The next one in the order of arrival.
  void add(Ping ping);                        ///< Likewise.
  void shed(const Ping& ping);  ///< A ping came but is not to be looked at: there is no time for it.
  /// Within `Sink::accept`: there was no time for the ping after all. It counts as shed, and its returns as
  /// none.
  void shed_accepted();
  void finish();           ///< There is no more: what still waits for a pose will not get one.
  void start_new_clock();  ///< What comes now is on another clock, as who keeps a recording knows.

  const IntakeCounts& counts() const { return ledger_.counts; }  ///< Since the start.
  /// What came so far was another process's: counts from now on, and believes a pause at once.
  void go_on_after_restart();
  std::int64_t newest_utime() const;  ///< Of the data that was believed [us]; 0 before any.

 private:
  /// What is known of one sensor.
  struct Sensor {
    ClockGuard clock;
    SensorGuards guards;
    std::vector<Ping> held = {};  ///< Suspect, and each later than the one before.
    std::optional<std::int64_t> last_out = {};
  };

  void watch_heading(const core::VehicleState& state);
  Sensor* sensor_of(const Ping& ping);
  void hold(Sensor& sensor, Ping ping);
  void release(Sensor& sensor);
  void refuse_held(Sensor& sensor);
  void enqueue(Sensor& sensor, Ping ping);
  void bound_waiting();
  void hand_out_what_has_a_pose();
  void hand_out(const core::Pose2& T_earth_body);
  std::string_view contradiction(Sensor& sensor, const DroppedReturns& dropped,
                                 const core::Pose2& T_earth_body);
  void leave(Sensor& sensor, const Ping& ping);
  void give_up_first(std::string_view reason);
  std::string why_no_pose(std::int64_t utime) const;
  void begin_new_clock(Sensor& first, std::int64_t utime);
  bool is_back(std::int64_t begin, std::int64_t utime) const;
  void forget_clock();
  void refuse_out_of_time(Sensor& sensor, const Ping& ping, std::string_view reason);
  void reject(const Ping& ping, std::string_view reason, std::int64_t& count);

  core::SonarParams configured_;
  Sink sink_;
  IntakeParams params_;
  std::int64_t pose_wait_;  ///< How long a ping waits for its pose [us].
  PoseIntake states_;
  std::map<std::int32_t, Sensor> sensors_;
  ReorderHold hold_;
  WaitingPings<Ping> waiting_;
  std::optional<std::int64_t> handed_out_;  ///< Time of the newest ping that has left [us].
  std::optional<std::int64_t> accepted_;    ///< Of those, of the newest that was accepted [us].
  Posed posed_;
  IntakeCounts before_;  ///< As they were before the ping that is accepted.
  IntakeLedger ledger_;
};

extern template class PingIntake<core::SonarScan>;
extern template class PingIntake<core::SonarImage>;

using ScanIntake = PingIntake<core::SonarScan>;    ///< Of scans.
using ImageIntake = PingIntake<core::SonarImage>;  ///< Of images.

}  // namespace lookout::tracking
