#include "tracking/intake/scan_intake.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

#include "core/time_text.hpp"
#include "tracking/intake/ping_checks.hpp"

namespace lookout::tracking {
namespace {

using Verdict = ClockGuard::Verdict;

constexpr const char* name_of(const core::SonarScan&) {
  return "scan";
}
constexpr const char* name_of(const core::SonarImage&) {
  return "image";
}

core::SonarScan& ping_of(core::PosedScan& posed) {
  return posed.scan;
}
core::SonarImage& ping_of(core::PosedImage& posed) {
  return posed.image;
}

/// Whether the n-th event of a kind is worth a line: the first, second, fourth, ..., so that a stream of bad
/// input does not become a stream of lines.
bool worth_a_line(std::int64_t n) {
  return (n & (n - 1)) == 0;
}

std::string at_time(std::int64_t utime) {
  return " at " + core::time_text(utime) + " s";
}

}  // namespace

template <class Ping>
PingIntake<Ping>::PingIntake(const core::SonarParams& configured, Sink sink, const IntakeParams& params)
    : configured_(configured),
      sink_(std::move(sink)),
      params_(params),
      state_clock_(params.clock),
      ping_clock_(params.clock) {
  if (params.max_wait < 0)
    throw std::invalid_argument("max_wait must be >= 0, got " + std::to_string(params.max_wait));
  if (params.max_waiting < 1) throw std::invalid_argument("max_waiting must be >= 1, got 0");
}

template <class Ping>
void PingIntake<Ping>::add(const core::VehicleState& state) {
  if (const auto reason = defect(state); !reason.empty()) return report_state(state, reason);
  switch (state_clock_.judge(state.utime)) {
    case Verdict::suspect:
      if (state_clock_.suspects() == 1) suspect_poses_.clear();
      suspect_poses_.add(state);
      return report_state(state, "out of time");
    case Verdict::new_clock:
      suspect_poses_.add(state);
      poses_ = std::exchange(suspect_poses_, core::PoseHistory());
      sink_.report("vehicle states are on a new clock" + at_time(state.utime));
      break;
    case Verdict::in_order:
      poses_.add(state);
      break;
  }
  hand_out_what_has_a_pose();
}

template <class Ping>
void PingIntake<Ping>::add(Ping ping) {
  if (const auto reason = defect(ping); !reason.empty()) return reject(ping, reason, counts_.damaged);
  const Verdict verdict = ping_clock_.judge(ping.utime);
  if (verdict == Verdict::suspect)
    return reject(ping, "time repeats, goes back or jumps ahead", counts_.out_of_time);
  if (verdict == Verdict::new_clock) begin_new_clock(ping.utime);
  count_sequence(ping.sequence);
  if (waiting_.size() >= params_.max_waiting) {
    reject(waiting_.front(), "no pose", counts_.no_pose);
    waiting_.pop_front();
  }
  waiting_.push_back(std::move(ping));
  hand_out_what_has_a_pose();
}

template <class Ping>
void PingIntake<Ping>::finish() {
  for (const Ping& ping : waiting_) reject(ping, "no pose", counts_.no_pose);
  waiting_.clear();
}

template <class Ping>
std::int64_t PingIntake<Ping>::newest_utime() const {
  if (!ping_clock_.last()) return state_clock_.last().value_or(0);
  return std::max(*ping_clock_.last(), state_clock_.last().value_or(*ping_clock_.last()));
}

template <class Ping>
void PingIntake<Ping>::hand_out_what_has_a_pose() {
  while (!waiting_.empty()) {
    const Ping& ping = waiting_.front();
    if (const auto T_earth_body = poses_.at(ping.utime)) {
      hand_out(*T_earth_body);
    } else if (poses_.reaches(ping.utime) || newest_utime() - ping.utime > params_.max_wait) {
      reject(ping, "no pose", counts_.no_pose);
      waiting_.pop_front();
    } else {
      return;
    }
  }
}

template <class Ping>
void PingIntake<Ping>::hand_out(const core::Pose2& T_earth_body) {
  Ping& ping = ping_of(posed_);
  ping = std::move(waiting_.front());
  waiting_.pop_front();
  posed_.T_earth_sonar = core::compose(T_earth_body, ping.T_body_sonar);
  counts_.dropped_returns += drop_out_of_bounds(ping);
  if (!agrees(ping, configured_) && worth_a_line(++counts_.other_geometry))
    sink_.report(std::string(name_of(ping)) + at_time(ping.utime) +
                 " has another geometry than the configuration; the message wins (" +
                 std::to_string(counts_.other_geometry) + " so far)");
  ++counts_.accepted;
  sink_.accept(posed_);
}

template <class Ping>
void PingIntake<Ping>::begin_new_clock(std::int64_t utime) {
  finish();
  if (state_clock_.adopt_suspects_near(utime)) poses_ = std::exchange(suspect_poses_, core::PoseHistory());
  sequence_.forget();
  ++counts_.resets;
  sink_.report("new clock" + at_time(utime) + ": everything starts again (" + std::to_string(counts_.resets) +
               " so far)");
  sink_.reset();
}

template <class Ping>
void PingIntake<Ping>::count_sequence(std::int64_t sequence) {
  using Step = core::SequenceGaps::Step;
  const auto lost_before = static_cast<std::uint64_t>(sequence_.lost());
  const Step step = sequence_.add(sequence);
  counts_.lost = sequence_.lost();
  counts_.restarts = sequence_.restarts();
  // At the first, the second, the fourth, ... that is lost.
  if (step == Step::gap &&
      std::bit_width(static_cast<std::uint64_t>(counts_.lost)) > std::bit_width(lost_before))
    sink_.report("lost before sequence " + std::to_string(sequence) + " (" + std::to_string(counts_.lost) +
                 " so far)");
  if (step == Step::restart && worth_a_line(counts_.restarts))
    sink_.report("sequence starts again at " + std::to_string(sequence) + " (" +
                 std::to_string(counts_.restarts) + " so far)");
}

template <class Ping>
void PingIntake<Ping>::reject(const Ping& ping, std::string_view reason, std::int64_t& count) {
  if (worth_a_line(++count))
    sink_.report(std::string(name_of(ping)) + at_time(ping.utime) + " rejected: " + std::string(reason) +
                 " (" + std::to_string(count) + " so far)");
}

template <class Ping>
void PingIntake<Ping>::report_state(const core::VehicleState& state, std::string_view reason) {
  if (worth_a_line(++counts_.bad_states))
    sink_.report("vehicle state" + at_time(state.utime) + " rejected: " + std::string(reason) + " (" +
                 std::to_string(counts_.bad_states) + " so far)");
}

template class PingIntake<core::SonarScan>;
template class PingIntake<core::SonarImage>;

}  // namespace lookout::tracking
