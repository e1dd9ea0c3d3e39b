#include "tracking/intake/clock_guard.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace lookout::tracking {

ClockGuard::ClockGuard(const ClockGuardParams& params) : params_(params) {
  if (params.max_step <= 0)
    throw std::invalid_argument("max_step must be > 0, got " + std::to_string(params.max_step));
  if (params.new_clock_after < 1)
    throw std::invalid_argument("new_clock_after must be >= 1, got " +
                                std::to_string(params.new_clock_after));
}

bool ClockGuard::follows(std::int64_t before, std::int64_t utime) const {
  return utime > before && utime - before <= params_.max_step;
}

ClockGuard::Verdict ClockGuard::judge(std::int64_t utime) {
  if (!last_ || follows(*last_, utime)) {
    last_ = utime;
    num_suspects_ = 0;
    return Verdict::in_order;
  }
  num_suspects_ = num_suspects_ > 0 && follows(newest_suspect_, utime) ? num_suspects_ + 1 : 1;
  newest_suspect_ = utime;
  if (num_suspects_ < params_.new_clock_after) return Verdict::suspect;
  last_ = utime;
  num_suspects_ = 0;
  return Verdict::new_clock;
}

bool ClockGuard::adopt_suspects_near(std::int64_t utime) {
  if (num_suspects_ == 0 || std::abs(newest_suspect_ - utime) > params_.max_step) return false;
  last_ = newest_suspect_;
  num_suspects_ = 0;
  return true;
}

}  // namespace lookout::tracking
