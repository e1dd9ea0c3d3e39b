#include "csht/joint/sensor_looks.hpp"

#include <algorithm>
#include <limits>

namespace lookout::csht {

int SensorLooks::take(std::int32_t sensor_id, std::int64_t utime) {
  const auto known = std::find_if(looks_.begin(), looks_.end(),
                                  [sensor_id](const Look& look) { return look.sensor_id == sensor_id; });
  newest_ = static_cast<std::size_t>(known - looks_.begin());
  if (known == looks_.end() && looks_.size() < kMost) looks_.push_back({sensor_id, utime, 0});
  newest_ = std::min(newest_, looks_.size() - 1);
  Look& look = looks_[newest_];
  if (utime > look.utime) look.period = utime - look.utime;
  look.utime = utime;
  return static_cast<int>(newest_);
}

std::int64_t SensorLooks::oldest() const {
  if (looks_.empty()) return std::numeric_limits<std::int64_t>::max();
  const Look& newest = looks_[newest_];
  std::int64_t oldest = newest.utime;
  for (const Look& look : looks_) {
    const std::int64_t period = std::max(look.period, newest.period);  // 0: not known yet.
    if (period == 0 || newest.utime - look.utime <= kSilentPeriods * period)
      oldest = std::min(oldest, look.utime);
  }
  return oldest;
}

}  // namespace lookout::csht
