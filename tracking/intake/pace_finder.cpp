#include "tracking/intake/pace_finder.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "core/frames.hpp"

namespace lookout::tracking {

std::optional<double> PaceFinder::middle(const Stream& stream) {
  const std::size_t count = std::min(stream.count, kSteps);
  if (count < kFewest) return std::nullopt;
  const auto steps = std::span(stream.steps).first(count);
  std::int64_t stride = std::numeric_limits<std::int64_t>::max();  // What the driver counts a ping as.
  for (const Step& step : steps)
    if (step.numbers > 0) stride = std::min(stride, step.numbers);
  std::array<double, kSteps> seconds;
  std::transform(steps.begin(), steps.end(), seconds.begin(), [stride](const Step& step) {
    const std::int64_t pings = step.numbers / stride;
    return pings < 1 || pings > kMostLost ? step.seconds : step.seconds / static_cast<double>(pings);
  });
  // Of an even number the longer: no mean of two paces, and who waits too long loses less than who does not.
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(seconds.begin(), middle, seconds.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

/// A sensor that is silent while another makes so many steps is slower, or off: it says nothing of the
/// fastest.
void PaceFinder::forget_slower_than(double step, std::int64_t utime) {
  std::erase_if(streams_, [step, utime](const auto& other) {
    return core::seconds(utime - other.second.last.utime) > static_cast<double>(kFewest) * step;
  });
}

std::optional<double> PaceFinder::pace() const {
  std::optional<double> fastest;
  for (const auto& [id, stream] : streams_) {
    const auto step = middle(stream);
    if (!step) return std::nullopt;  // One that is yet unknown may be the fastest.
    fastest = fastest ? std::min(*fastest, *step) : step;
  }
  return fastest;
}

void PaceFinder::skip(std::int32_t sensor_id) {
  const auto found = streams_.find(sensor_id);
  if (found != streams_.end()) found->second.has_gap = true;
}

std::optional<double> PaceFinder::learn(const Ping& ping) {
  const auto found = streams_.try_emplace(ping.sensor_id, Stream{ping, {}, 0}).first;
  Stream& stream = found->second;
  const double step = core::seconds(ping.utime - stream.last.utime);
  if (!std::exchange(stream.has_gap, false) && step > 0.0)
    stream.steps[stream.count++ % kSteps] = {step, ping.sequence - stream.last.sequence};
  stream.last = ping;
  if (const auto own = middle(stream)) forget_slower_than(*own, ping.utime);
  const auto pace = this->pace();
  if (!pace) return std::nullopt;
  const double period = std::max(configured_, *pace);
  if (period <= kOff * in_use_ && in_use_ <= kOff * period) return std::nullopt;
  in_use_ = period;
  return period;
}

}  // namespace lookout::tracking
