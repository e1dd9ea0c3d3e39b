#include "tracking/restart/clock_step.hpp"

#include <cmath>
#include <utility>

namespace lookout::tracking {
namespace {

constexpr double kLongestPause = 10.0;  // s over which a sensor's numbers say that it went on
// Choices of ours: what tells a vehicle that was under way and stayed from one that slept.
constexpr double kBaseline = 10.0;  // s over which its speed is taken, so that the noise of fixes is small
constexpr double kShortest = 3.0;   // s of that which must be known
constexpr double kSlowest = 0.5;    // m/s: one that is slower may have rested
constexpr double kFar = 100.0;      // m that it would have gone at least
constexpr double kStayed = 5.0;     // m beside the way of the pause within which it is where it was

double seconds_between(const core::RememberedScan& from, const core::RememberedScan& to) {
  return core::seconds(to.scan.utime - from.scan.utime);
}

double numbers_between(const core::RememberedScan& from, const core::RememberedScan& to) {
  return static_cast<double>(to.scan.sequence) - static_cast<double>(from.scan.sequence);
}

double metres_between(const core::RememberedScan& from, const core::RememberedScan& to) {
  const core::Pose2 &a = from.vehicle.T_earth_body, &b = to.vehicle.T_earth_body;
  return std::hypot(b.north - a.north, b.east - a.east);
}

/// Speed of the vehicle by its places over the newest scans [m/s]; 0 where they tell too little.
double speed_over(const std::vector<core::RememberedScan>& before) {
  const core::RememberedScan *first = nullptr, &last = before.back();
  for (const auto& one : before)
    if (first == nullptr && seconds_between(one, last) <= kBaseline) first = &one;
  const double seconds = seconds_between(*first, last);
  return seconds >= kShortest ? metres_between(*first, last) / seconds : 0.0;
}

/// Whether the vehicle stayed where a `step` of time [s] would have carried it away; `pause` [s] went by.
bool stayed(const std::vector<core::RememberedScan>& before, const core::RememberedScan& first, double pause,
            double step) {
  const double speed = speed_over(before);
  return speed >= kSlowest && speed * step >= kFar &&
         metres_between(before.back(), first) <= speed * pause + kStayed;
}

}  // namespace

std::optional<std::int64_t> clock_step(const std::vector<core::RememberedScan>& before,
                                       const core::RememberedScan& first) {
  const core::RememberedScan *last = nullptr, *earlier = nullptr;
  for (const auto& one : before)
    if (one.scan.sensor_id == first.scan.sensor_id) earlier = std::exchange(last, &one);
  if (earlier == nullptr) return std::nullopt;
  const double period = seconds_between(*earlier, *last) / numbers_between(*earlier, *last);
  const double pause = numbers_between(*last, first) * period;
  if (!(period > 0.0 && pause > 0.0 && pause <= kLongestPause)) return std::nullopt;
  const std::int64_t step = first.scan.utime - (last->scan.utime + core::microseconds(pause));
  const bool was_set = step < 0 || stayed(before, first, pause, core::seconds(step));
  return was_set ? std::optional(step) : std::nullopt;
}

}  // namespace lookout::tracking
