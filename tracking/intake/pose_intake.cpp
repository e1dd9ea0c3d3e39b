#include "tracking/intake/pose_intake.hpp"

#include <utility>

#include "tracking/intake/ping_checks.hpp"

namespace lookout::tracking {

using Verdict = ClockGuard::Verdict;

PoseIntake::PoseIntake(Sink sink, std::int64_t max_bracket, const ClockGuardParams& clock)
    : sink_(std::move(sink)), clock_(clock), poses_(max_bracket) {}

void PoseIntake::add(const core::VehicleState& state) {
  if (const auto reason = defect(state); !reason.empty()) return sink_.refuse(state, reason);
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

void PoseIntake::begin_new_clock(std::int64_t utime) {
  if (clock_.adopt_suspects_near(utime)) believe_held(true);
}

void PoseIntake::start_new_clock() {
  refuse_held();
  clock_.forget();
  poses_.clear();
}

void PoseIntake::finish() {
  if (clock_.adopt_suspects_ahead()) believe_held(false);
  refuse_held();
}

void PoseIntake::believe(const core::VehicleState& state, bool new_clock) {
  if (new_clock) poses_.clear();
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
