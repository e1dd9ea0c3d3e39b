#include "tracking/intake/pace_finder.hpp"

#include <algorithm>

#include "core/frames.hpp"

namespace lookout::tracking {

void PaceFinder::add_step(Stream& stream, const Ping& ping) {
  const std::int64_t numbers = ping.sequence - stream.last.sequence;
  const std::int64_t step = ping.utime - stream.last.utime;
  stream.last = ping;
  if (numbers < 0 || numbers > kMostLost || step <= 0) {
    stream.count = 0;
    return;
  }
  stream.steps[stream.count++ % kSteps] =
      core::seconds(step) / static_cast<double>(std::max<std::int64_t>(numbers, 1));
}

std::optional<double> PaceFinder::pace() const {
  std::optional<double> fastest;
  for (const auto& [id, stream] : streams_) {
    if (stream.count < kSteps) return std::nullopt;  // One that is yet unknown may be the fastest.
    auto steps = stream.steps;
    std::sort(steps.begin(), steps.end());
    const double middle = steps[(kSteps - 1) / 2];  // Of an even number the shorter: no mean of two paces.
    fastest = fastest ? std::min(*fastest, middle) : middle;
  }
  return fastest;
}

std::optional<double> PaceFinder::learn(const Ping& ping) {
  const auto [found, is_new] = streams_.try_emplace(ping.sensor_id, Stream{ping, {}, 0});
  if (!is_new) add_step(found->second, ping);
  const auto pace = this->pace();
  if (!pace) return std::nullopt;
  const double period = std::max(configured_, *pace);
  if (period <= kOff * in_use_ && in_use_ <= kOff * period) return std::nullopt;
  in_use_ = period;
  return period;
}

}  // namespace lookout::tracking
