#include "tracking/intake/stamp_clock.hpp"

namespace lookout::tracking {

void StampClock::add(std::int64_t utime, std::int64_t heard) {
  const std::int64_t step = utime - utime_.value_or(utime), passed = heard - heard_;
  utime_ = utime;
  heard_ = heard;
  if (step <= 0 || passed < 0) return;
  ++steps_;
  stamped_ += static_cast<double>(step);
  passed_ += static_cast<double>(passed);
  if (slower()) ++doubted_;
}

std::optional<std::int64_t> StampClock::slower() const {
  if (steps_ < kSteps || passed_ < static_cast<double>(kSpan)) return std::nullopt;
  for (const std::int64_t unit : {1'000, 1'000'000}) {
    const double off = passed_ / stamped_ / static_cast<double>(unit);
    if (off < kAlike && off > 1.0 / kAlike) return unit;
  }
  return std::nullopt;
}

}  // namespace lookout::tracking
