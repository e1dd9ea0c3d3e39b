#include "tracking/intake/clock_guard.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/parameter_check.hpp"

namespace lookout::tracking {
namespace {

/// A pause is a step of more than this many times the step before.
constexpr std::int64_t kPause = 3;
/// Times in a row that show a pause rather than one bad stamp.
constexpr int kResumedAfter = 2;
/// Leaps are alike where the longer is less than so many times the shorter.
constexpr std::int64_t kAlike = 2;
/// Slowest sensor: core::SonarLimits' longest period [us].
constexpr std::int64_t kSlowest = 3'600'000'000;

}  // namespace

ClockGuard::ClockGuard(const ClockGuardParams& params) : params_(params) {
  core::require(params.max_step > 0, "max_step must be > 0", static_cast<double>(params.max_step));
  core::require(params.new_clock_after >= 1, "new_clock_after must be >= 1", params.new_clock_after);
  core::require(params.max_late >= 0, "max_late must be >= 0", static_cast<double>(params.max_late));
  core::require(params.max_leap > 0, "max_leap must be > 0", static_cast<double>(params.max_leap));
}

bool ClockGuard::follows(std::int64_t before, std::int64_t utime) const {
  return utime > before && utime - before <= max_step();
}

void ClockGuard::watch_slow_pace(std::int64_t utime) {
  const std::int64_t leap = utime - (num_suspects_ > 0 ? newest_suspect_ : *last_);
  const std::int64_t shorter = std::min(leap, leap_), longer = std::max(leap, leap_);
  leap_ = leap;
  if (kPause * shorter > params_.max_step && longer < kAlike * shorter && longer <= kSlowest)
    slow_ = kPause * longer;
}

void ClockGuard::believe(std::int64_t utime) {
  if (last_) step_ = std::clamp<std::int64_t>(utime - *last_, 0, max_step());
  last_ = utime;
  num_suspects_ = 0;
}

ClockGuard::Verdict ClockGuard::judge(std::int64_t utime) {
  const std::int64_t longest = std::min(max_step(), std::max(params_.max_leap, kPause * step_));
  // Several suspects that go on are a clock that was set back, though it comes near the old one again.
  const std::int64_t beside = utime - newest_suspect_;
  if (num_suspects_ >= kResumedAfter && beside > 0 && beside <= longest) return suspect(utime);
  const std::int64_t step = last_ ? utime - *last_ : 1;
  if (step <= 0 && step >= -params_.max_late) return Verdict::late;
  const bool is_pause = std::exchange(expects_pause_, false) && step > longest && step <= max_step();
  if (step <= 0 || (step > longest && !is_pause)) return suspect(utime);
  if (is_pause) last_.reset();  // It says nothing of the stream's pace.
  believe(utime);
  return Verdict::in_order;
}

ClockGuard::Verdict ClockGuard::suspect(std::int64_t utime) {
  watch_slow_pace(utime);
  // Suspects ahead that agree, and a leap farther ahead: a stream with long pauses, and too few times
  // between.
  const bool is_ahead = num_suspects_ >= kResumedAfter && newest_suspect_ > *last_ && utime > newest_suspect_;
  const bool goes_on = is_ahead || (num_suspects_ > 0 && follows(newest_suspect_, utime));
  num_suspects_ = goes_on ? num_suspects_ + 1 : 1;
  const std::int64_t before = newest_suspect_;
  newest_suspect_ = utime;
  const bool same_clock = follows(*last_, utime) && num_suspects_ >= kResumedAfter && follows(*last_, before);
  if (!same_clock && num_suspects_ < params_.new_clock_after) return Verdict::suspect;
  if (num_suspects_ > 1) last_ = before;  // The step among the new ones is the one to go by.
  believe(utime);
  return same_clock ? Verdict::resumed : Verdict::new_clock;
}

bool ClockGuard::adopt_suspects_near(std::int64_t utime) {
  if (num_suspects_ == 0 || std::abs(newest_suspect_ - utime) > params_.max_step) return false;
  last_.reset();  // The step to another clock, or over a pause, says nothing of the stream's pace.
  believe(newest_suspect_);
  return true;
}

bool ClockGuard::adopt_suspects_ahead() {
  return num_suspects_ > 0 && follows(*last_, newest_suspect_) && adopt_suspects_near(newest_suspect_);
}

}  // namespace lookout::tracking
