#include "tools/import/wrapped_clock.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tools {
namespace {

constexpr std::uint32_t kMostPings = 1U << 31U;  // More of them forward is a step back.

}  // namespace

double WrappedClock::add(std::uint32_t number, double start, double wrap) {
  if (last_) {
    const std::uint32_t pings = number - last_->number;
    const bool restarted = pings == 0 || pings >= kMostPings;
    if (restarted) ++restarts_;
    const double step = restarted ? period_.value_or(0.0) : step_of(pings, start, wrap);
    if (!restarted) period_ = step / pings;
    elapsed_ += step;
  }
  last_ = Ping{number, start};
  return elapsed_;
}

double WrappedClock::step_of(std::uint32_t pings, double start, double wrap) const {
  const double step = start - last_->start;
  if (!(wrap > 0.0)) return std::max(0.0, step);
  const double within = step < 0.0 ? step + wrap : step;
  if (!period_) return within;
  return within + wrap * std::max(0.0, std::round((pings * *period_ - within) / wrap));
}

}  // namespace lookout::tools
