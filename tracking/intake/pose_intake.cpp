#include "tracking/intake/pose_intake.hpp"

#include <utility>

#include "tracking/intake/ping_checks.hpp"

namespace lookout::tracking {

namespace {

constexpr double kMoves = 0.05;  // Slower than this a vehicle may rest [m/s].

}  // namespace

using Verdict = ClockGuard::Verdict;

PoseIntake::PoseIntake(Sink sink, std::int64_t max_bracket, const ClockGuardParams& clock)
    : sink_(std::move(sink)), clock_(clock), poses_(max_bracket) {}

void PoseIntake::add(const core::VehicleState& state) {
  if (const auto reason = defect(state); !reason.empty()) return sink_.refuse(state, reason);
  if (is_frozen(state)) return sink_.refuse(state, "its pose repeats to the bit while it says that it moves");
  switch (const Verdict verdict = clock_.judge(state.utime); verdict) {
    case Verdict::in_order:
      refuse_held();
      [[fallthrough]];
    case Verdict::late:
      return believe(state, false);
    case Verdict::suspect:
      if (clock_.suspects() == 1) refuse_held();
      held_.push_back(state);
      return;
    case Verdict::resumed:
    case Verdict::new_clock:
      held_.push_back(state);
      return believe_held(verdict == Verdict::new_clock);
  }
}

/// Whether a vehicle that says it moves is where it was: navigation hangs or repeats its last fix.
bool PoseIntake::is_frozen(const core::VehicleState& state) {
  const auto before = std::exchange(newest_, state);
  if (!before || before->utime == state.utime || state.velocity.norm() < kMoves) return false;
  const core::Pose2 &now = state.T_earth_body, &then = before->T_earth_body;
  return now.north == then.north && now.east == then.east && now.heading == then.heading;
}

void PoseIntake::begin_new_clock(std::int64_t utime) {
  if (clock_.adopt_suspects_near(utime)) believe_held(true);
}

void PoseIntake::start_new_clock() {
  refuse_held();
  clock_.forget();
  guard_.forget();
  poses_.clear();
}

void PoseIntake::finish() {
  if (clock_.adopt_suspects_ahead()) believe_held(false);
  refuse_held();
}

void PoseIntake::believe(const core::VehicleState& state, bool new_clock) {
  if (new_clock) poses_.clear();
  if (new_clock) guard_.forget();
  if (const auto reason = guard_.doubt(state); !reason.empty()) return sink_.refuse(state, reason);
  poses_.add(state);
  if (sink_.believe) sink_.believe(state, new_clock);
}

void PoseIntake::believe_held(bool new_clock) {
  for (const auto& state : std::exchange(held_, {})) believe(state, std::exchange(new_clock, false));
}

void PoseIntake::refuse_held() {
  for (const auto& state : std::exchange(held_, {})) sink_.refuse(state, "out of time");
}

}  // namespace lookout::tracking
