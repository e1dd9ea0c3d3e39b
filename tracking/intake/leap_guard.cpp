#include "tracking/intake/leap_guard.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/frames.hpp"

namespace lookout::tracking {

bool LeapGuard::is_leap(std::int64_t utime, double off) {
  if (!newest_) begin_ = utime;
  bool is_leap = newest_ && is_off(utime, off);
  if (is_leap && !leap_) leap_ = Leap{off, utime};
  if (is_leap && is_over(utime)) {
    is_leap = false;
    begin_ = utime;
    rest_until_ = utime + params_.rest;
  }
  if (!is_leap) leap_.reset();
  newest_ = std::max(newest_.value_or(utime), utime);
  return is_leap;
}

bool LeapGuard::is_off(std::int64_t utime, double off) const {
  if (leap_) return off > params_.nearest * leap_->size;
  const std::int64_t step = std::abs(utime - *newest_);
  if (step > params_.longest_step || (rest_until_ && utime < *rest_until_)) return false;
  return off > params_.leap + params_.rate * core::seconds(step);
}

/// Whether the leap has lasted so long that it is believed.
bool LeapGuard::is_over(std::int64_t utime) const {
  return utime - leap_->since > std::min(params_.patience, leap_->since - begin_);
}

}  // namespace lookout::tracking
