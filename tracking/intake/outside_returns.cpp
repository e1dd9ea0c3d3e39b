#include "tracking/intake/outside_returns.hpp"

#include <algorithm>

namespace lookout::tracking {

bool OutsideReturns::contradict(int outside, int all, std::int64_t utime) {
  if (is_sudden(outside, all)) {
    if (!since_) since_ = utime;
    if (utime - *since_ <= params_.patience) return true;
    scans_ = 0;
  }
  since_.reset();
  if (all > 0) learn(static_cast<double>(outside) / all);
  return false;
}

bool OutsideReturns::is_sudden(int outside, int all) const {
  return scans_ >= params_.known_after && usual_ < params_.usual && outside >= params_.fewest &&
         outside > params_.most * all;
}

void OutsideReturns::learn(double share) {
  scans_ = std::min(scans_ + 1, params_.memory);
  usual_ += (share - usual_) / scans_;
}

}  // namespace lookout::tracking
