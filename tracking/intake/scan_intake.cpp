#include "tracking/intake/scan_intake.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/files/csv.hpp"
#include "core/files/time_text.hpp"
#include "tracking/intake/intake_words.hpp"
#include "tracking/intake/ping_checks.hpp"

namespace lookout::tracking {
namespace {

using Verdict = ClockGuard::Verdict;

/// Sensors that one vehicle is likely to carry; more of them are damaged messages.
constexpr std::size_t kMaxSensors = 64;

/// A heading in radians stays within; one in degrees seldom does [rad].
constexpr double kTwoTurns = 4.0 * std::numbers::pi;

core::SonarScan& ping_of(core::PosedScan& posed) {
  return posed.scan;
}
core::SonarImage& ping_of(core::PosedImage& posed) {
  return posed.image;
}

std::int64_t num_returns(const core::SonarScan& scan) {
  return static_cast<std::int64_t>(scan.returns.size());
}
std::int64_t num_returns(const core::SonarImage& /*image*/) {
  return 0;
}

std::int64_t max_pose_gap(const core::SonarParams& configured) {
  return core::microseconds(configured.max_pose_gap);
}

/// Scans of a slow sensor that may be missing before its next one is on another clock.
constexpr double kMissing = 2.0;

/// A clock on which a message may be as late as it may be waited for, and the next one a few periods away.
ClockGuardParams clock_of(const IntakeParams& params, const core::SonarParams& configured) {
  ClockGuardParams clock = params.clock;
  clock.max_late = params.max_wait;
  clock.max_step = std::max(clock.max_step, core::microseconds((1.0 + kMissing) * configured.scan_period));
  return clock;
}

/// The same of vehicle states: a gap that poses are interpolated across is no leap of their clock.
ClockGuardParams state_clock_of(const IntakeParams& params, const core::SonarParams& configured) {
  ClockGuardParams clock = clock_of(params, configured);
  clock.max_leap = std::max(clock.max_leap, max_pose_gap(configured));
  clock.max_step = std::max(clock.max_step, max_pose_gap(configured));
  return clock;
}

IntakeParams checked(IntakeParams params, const core::SonarParams& configured) {
  if (params.max_wait < 0)
    throw std::invalid_argument("max_wait must be >= 0, got " + std::to_string(params.max_wait));
  if (params.max_waiting < 1) throw std::invalid_argument("max_waiting must be >= 1, got 0");
  if (configured.max_wait != core::SonarParams().max_wait)
    params.max_wait = core::microseconds(configured.max_wait);
  return params;
}

/// How long a scan waits for its pose [us]: at least as long as the gap between two states that is allowed.
std::int64_t pose_wait(const IntakeParams& params, const core::SonarParams& configured) {
  const std::int64_t gap = max_pose_gap(configured);
  return gap > core::PoseHistory::kMaxBracket ? std::max(gap, params.max_wait) : params.max_wait;
}

}  // namespace

template <class Ping>
PingIntake<Ping>::PingIntake(const core::SonarParams& configured, Sink sink, const IntakeParams& params)
    : configured_(configured),
      sink_(std::move(sink)),
      params_(checked(params, configured)),
      pose_wait_(pose_wait(params_, configured)),
      states_({[this](const core::VehicleState& state, std::string_view reason) {
                 if (worth_a_line(++ledger_.counts.bad_states))
                   sink_.report("vehicle state" + at_time(state.utime) + " rejected: " + std::string(reason) +
                                so_far(ledger_.counts.bad_states));
               },
               [this](const core::VehicleState& state, bool new_clock) {
                 ++ledger_.counts.accepted_states;
                 watch_heading(state);
                 if (new_clock) sink_.report("vehicle states are on a new clock" + at_time(state.utime));
                 if (sink_.believe) sink_.believe(state, new_clock);
               }},
              max_pose_gap(configured), state_clock_of(params_, configured)),
      hold_(params_.max_wait) {
  ledger_.report = sink_.report;
}

template <class Ping>
void PingIntake<Ping>::watch_heading(const core::VehicleState& state) {
  const double heading = std::abs(state.T_earth_body.heading);
  if (heading > kTwoTurns && worth_a_line(++ledger_.counts.wide_headings))
    sink_.report("vehicle state" + at_time(state.utime) + " has a heading of " + core::shortest(heading) +
                 " rad, beyond two turns: degrees?" + so_far(ledger_.counts.wide_headings));
}

template <class Ping>
void PingIntake<Ping>::add(const core::VehicleState& state) {
  ++ledger_.counts.states;
  states_.add(state);
  hand_out_what_has_a_pose();
}

template <class Ping>
void PingIntake<Ping>::add(Ping ping) {
  ++ledger_.counts.received;
  if (const auto reason = defect(ping); !reason.empty()) return reject(ping, reason, ledger_.counts.damaged);
  Sensor* sensor = sensor_of(ping);
  if (sensor == nullptr) return reject(ping, "more sensors than 64 on one vehicle", ledger_.counts.damaged);
  if (sensor->guards.is_foreign(ping.sequence, ping.utime))
    return reject(ping, "another sender speaks under its sensor_id, in numbers of its own",
                  ledger_.counts.foreign);
  sensor->guards.watch_pace(ping);
  const std::int64_t utime = ping.utime;
  const Verdict verdict = sensor->clock.judge(utime);
  if (verdict == Verdict::in_order) refuse_held(*sensor);
  if (verdict == Verdict::in_order || verdict == Verdict::late)
    enqueue(*sensor, std::move(ping));
  else
    hold(*sensor, std::move(ping));
  if (verdict == Verdict::resumed) release(*sensor);
  if (verdict == Verdict::new_clock) begin_new_clock(*sensor, utime);
  hand_out_what_has_a_pose();
}

template <class Ping>
void PingIntake<Ping>::go_on_after_restart() {
  ledger_.counts = {};
  states_.expect_pause();
  for (auto& [id, sensor] : sensors_) sensor.clock.expect_pause();
}

template <class Ping>
void PingIntake<Ping>::shed(const Ping& ping) {
  ++ledger_.counts.received;
  ++ledger_.counts.shed;
  Sensor* sensor = sensor_of(ping);
  if (sensor != nullptr) sensor->guards.number_is_refused(ping.sequence);
}

template <class Ping>
void PingIntake<Ping>::shed_accepted() {
  ledger_.counts = before_;
  ++ledger_.counts.shed;
}

template <class Ping>
typename PingIntake<Ping>::Sensor* PingIntake<Ping>::sensor_of(const Ping& ping) {
  const auto found = sensors_.find(ping.sensor_id);
  if (found != sensors_.end()) return &found->second;
  if (sensors_.size() >= kMaxSensors) return nullptr;
  Sensor sensor{ClockGuard(clock_of(params_, configured_)), SensorGuards(configured_, ledger_)};
  return &sensors_.emplace(ping.sensor_id, std::move(sensor)).first->second;
}

/// Keeps a suspect until others agree with it. The first of its kind replaces those that nothing agreed with.
template <class Ping>
void PingIntake<Ping>::hold(Sensor& sensor, Ping ping) {
  if (sensor.clock.suspects() == 1) refuse_held(sensor);
  sensor.held.push_back(std::move(ping));
}

template <class Ping>
void PingIntake<Ping>::release(Sensor& sensor) {
  for (Ping& ping : std::exchange(sensor.held, {})) enqueue(sensor, std::move(ping));
}

template <class Ping>
void PingIntake<Ping>::refuse_held(Sensor& sensor) {
  for (const Ping& ping : std::exchange(sensor.held, {}))
    refuse_out_of_time(sensor, ping, "its time goes back or leaps ahead, alone");
}

/// Puts a ping among those that wait.
template <class Ping>
void PingIntake<Ping>::enqueue(Sensor& sensor, Ping ping) {
  const std::int64_t utime = ping.utime;
  const bool too_late = handed_out_ && utime < *handed_out_;
  if (too_late || (!waiting_.empty() && utime < waiting_.last_utime()))
    hold_.note(newest_utime() - utime, newest_utime(), too_late);
  if (sensor.last_out && utime == *sensor.last_out)
    return refuse_out_of_time(sensor, ping, "its time repeats");
  if (too_late) return refuse_out_of_time(sensor, ping, "comes too late");
  if (!waiting_.insert(ping)) return refuse_out_of_time(sensor, ping, "its time repeats");
  bound_waiting();
}

template <class Ping>
void PingIntake<Ping>::bound_waiting() {
  while (waiting_.size() > params_.max_waiting ||
         (waiting_.size() > 1 && waiting_.bytes() > params_.max_waiting_bytes))
    give_up_first("no pose, and too many wait for theirs");
}

template <class Ping>
void PingIntake<Ping>::finish() {
  states_.finish();
  for (auto& [id, sensor] : sensors_) {
    if (sensor.clock.adopt_suspects_ahead()) release(sensor);
    refuse_held(sensor);
  }
  hold_.forget();
  hand_out_what_has_a_pose();
  while (!waiting_.empty()) give_up_first(why_no_pose(waiting_.first_utime()));
}

template <class Ping>
std::int64_t PingIntake<Ping>::newest_utime() const {
  std::optional<std::int64_t> newest = states_.newest_utime();
  for (const auto& [id, sensor] : sensors_) newest = std::max(newest, sensor.clock.last());
  return newest.value_or(0);
}

template <class Ping>
void PingIntake<Ping>::hand_out_what_has_a_pose() {
  while (!waiting_.empty()) {
    const std::int64_t utime = waiting_.first_utime();
    const std::int64_t newest = newest_utime();
    if (newest - utime < hold_.at(newest)) return;
    if (const auto T_earth_body = states_.poses().at(utime)) {
      hand_out(*T_earth_body);
    } else if (states_.poses().reaches(utime) || newest - utime > pose_wait_) {
      give_up_first(why_no_pose(utime));
    } else {
      return;
    }
  }
}

template <class Ping>
void PingIntake<Ping>::hand_out(const core::Pose2& T_earth_body) {
  Ping& ping = ping_of(posed_);
  ping = waiting_.take_first();
  posed_.T_earth_sonar = core::compose(T_earth_body, ping.T_body_sonar);
  Sensor& sensor = sensors_.at(ping.sensor_id);
  sensor.guards.look_at(ping);
  leave(sensor, ping);
  if (sensor.guards.is_frozen(ping))
    return reject(ping, "its content repeats to the bit", ledger_.counts.frozen);
  const std::int64_t returns = num_returns(ping);
  const DroppedReturns dropped = sensor.guards.drop_returns_of(ping);
  if (const auto reason = contradiction(sensor, dropped, T_earth_body); !reason.empty())
    return reject(ping, reason, ledger_.counts.contradicting);
  before_ = ledger_.counts;
  ledger_.counts.returns += returns;
  ledger_.counts.silent_returns += dropped.silent;
  ledger_.counts.dropped_returns += dropped.out_of_bounds;
  ++ledger_.counts.accepted;
  accepted_ = ping.utime;
  sensor.guards.leave_out(ping);
  if (sink_.pose) sink_.pose(T_earth_body);
  sink_.accept(posed_);
}

/// What the ping that would be accepted contradicts: its own geometry, or what is tracked.
template <class Ping>
std::string_view PingIntake<Ping>::contradiction(Sensor& sensor, const DroppedReturns& dropped,
                                                 const core::Pose2& T_earth_body) {
  const Ping& ping = ping_of(posed_);
  const auto all = static_cast<int>(num_returns(ping)) + dropped.out_of_bounds;
  if (const auto reason = sensor.guards.contradiction(dropped, all, ping.utime); !reason.empty())
    return reason;
  return sink_.doubt ? sink_.doubt(posed_, T_earth_body) : std::string_view();
}

/// Notes that a ping no longer waits.
template <class Ping>
void PingIntake<Ping>::leave(Sensor& sensor, const Ping& ping) {
  sensor.guards.number_comes(ping.sequence);
  handed_out_ = sensor.last_out = ping.utime;
}

template <class Ping>
void PingIntake<Ping>::give_up_first(std::string_view reason) {
  const Ping ping = waiting_.take_first();
  Sensor& sensor = sensors_.at(ping.sensor_id);
  leave(sensor, ping);
  reject(ping, reason, ledger_.counts.no_pose);
}

template <class Ping>
std::string PingIntake<Ping>::why_no_pose(std::int64_t utime) const {
  if (const auto gap = states_.poses().gap_at(utime))
    return "no pose: the vehicle states around it are " + core::time_text(*gap) +
           " s apart, above max_pose_gap_s (" + core::shortest(configured_.max_pose_gap) +
           " s; set it in `sensor:` of the configuration)";
  if (!states_.newest_utime()) return "no pose: no vehicle state has come";
  if (states_.poses().reaches(utime)) return "no pose: it is older than the vehicle states";
  return "no pose: no vehicle state came within " + core::time_text(pose_wait_) +
         " s after it; max_pose_gap_s (" + core::shortest(configured_.max_pose_gap) + " s) and max_wait_s (" +
         core::time_text(params_.max_wait) +
         " s) in `sensor:` of the configuration say how far apart and how late they may be";
}

template <class Ping>
void PingIntake<Ping>::begin_new_clock(Sensor& first, std::int64_t utime) {
  const std::string from = handed_out_ ? ", after " + core::time_text(*handed_out_) + " s" : "";
  const auto begin = first.held.empty() ? utime : first.held.front().utime;
  hold_.forget();
  hand_out_what_has_a_pose();
  while (!waiting_.empty()) give_up_first("no pose before a new clock began");
  const bool back = is_back(begin, utime);
  states_.begin_new_clock(utime);
  std::vector<Sensor*> on_it{&first};
  for (auto& [id, sensor] : sensors_) {
    if (&sensor == &first) continue;
    if (sensor.clock.adopt_suspects_near(utime)) {
      on_it.push_back(&sensor);
    } else {
      refuse_held(sensor);
      sensor.clock.forget();
    }
  }
  forget_clock();
  if (back) {
    handed_out_ = accepted_;
    sink_.report("the clock is back" + at_time(begin) + from + ": tracking goes on");
  } else {
    accepted_.reset();
    ++ledger_.counts.resets;
    sink_.report("new clock" + at_time(begin) + from + ": tracking starts again, identities go on" +
                 so_far(ledger_.counts.resets));
    sink_.reset();
  }
  for (Sensor* sensor : on_it) release(*sensor);
}

/// Whether times from `begin` to `utime` are on the clock of what was last accepted and of the vehicle's
/// states: those in between, of which no pose was known, were the mistake.
template <class Ping>
bool PingIntake<Ping>::is_back(std::int64_t begin, std::int64_t utime) const {
  const auto states = states_.newest_utime();
  return accepted_ && states && begin > *accepted_ && utime - *accepted_ <= params_.clock.max_step &&
         std::abs(*states - utime) <= pose_wait_;
}

template <class Ping>
void PingIntake<Ping>::forget_clock() {
  handed_out_.reset();
  hold_.forget();
  for (auto& [id, sensor] : sensors_) {
    sensor.last_out.reset();
    sensor.guards.begin_new_clock();
  }
}

template <class Ping>
void PingIntake<Ping>::start_new_clock() {
  finish();
  states_.start_new_clock();
  for (auto& [id, sensor] : sensors_) sensor.clock.forget();
  forget_clock();
  accepted_.reset();
  ++ledger_.counts.resets;
  sink_.report("the recording goes on on a new clock: tracking starts again, identities go on" +
               so_far(ledger_.counts.resets));
  sink_.reset();
}

template <class Ping>
void PingIntake<Ping>::refuse_out_of_time(Sensor& sensor, const Ping& ping, std::string_view reason) {
  sensor.guards.number_is_refused(ping.sequence);
  reject(ping, reason, ledger_.counts.out_of_time);
}

template <class Ping>
void PingIntake<Ping>::reject(const Ping& ping, std::string_view reason, std::int64_t& count) {
  if (worth_a_line(++count))
    sink_.report(described(ping) + " rejected: " + std::string(reason) + so_far(count));
}

template class PingIntake<core::SonarScan>;
template class PingIntake<core::SonarImage>;

}  // namespace lookout::tracking
