#include "tracking/intake/unit_guard.hpp"

#include <algorithm>
#include <cmath>

#include "core/files/csv.hpp"
#include "core/pose_history.hpp"

namespace lookout::tracking {
namespace {

constexpr double kCentimetres = 100.0;  // A metre.

}  // namespace

UnitGuard::UnitGuard(double scan_period)
    : fast_(std::max(kFastest, core::microseconds(scan_period / kPeriods))),
      slow_(core::microseconds(scan_period * kPeriods)) {}

UnitGuard::Pace UnitGuard::judge_pace(std::int64_t utime) {
  const std::int64_t step = last_ ? utime - *last_ : fast_;
  last_ = utime;
  if (step == 0) return Pace::plausible;
  step_ = step;
  const Pace pace = step > slow_               ? Pace::too_slow
                    : step > 0 && step < fast_ ? Pace::too_fast
                                               : Pace::plausible;
  alike_ = pace == pace_ ? std::min(alike_ + 1, 2 * kShown) : 1;
  pace_ = pace;
  // A slow one that goes on is told and done with: tracking has taken it for the sensor's own by then.
  const bool settled = pace == Pace::too_slow && alike_ >= 2 * kShown;
  return alike_ >= kShown && !settled ? pace : Pace::plausible;
}

std::string UnitGuard::doubt_ranges(const Ranges& ranges) {
  if (ranges.all == 0 || looked_ >= kLooked) return {};
  sum_.all += ranges.all;
  sum_.outside += ranges.outside;
  sum_.farthest = std::max(sum_.farthest, ranges.farthest);
  if (++looked_ < kLooked) return {};
  const std::string all = "all " + std::to_string(sum_.all) + " returns so far lie ";
  if (sum_.outside == sum_.all)
    return all + "outside of its beams or range: degrees, millimetres, another geometry?";
  if (sum_.farthest < kNear * ranges.maximum)
    return all + "within " + core::shortest(std::ceil(sum_.farthest * kCentimetres) / kCentimetres) +
           " m of a range of " + core::shortest(ranges.maximum) + " m: kilometres?";
  return {};
}

void UnitGuard::begin_new_clock() {
  last_.reset();
  alike_ = 0;
}

}  // namespace lookout::tracking
