#include "tracking/intake/several_returns.hpp"

#include <algorithm>

#include "tracking/intake/crowded_scan.hpp"

namespace lookout::tracking {

std::optional<double> SeveralReturns::learn(const core::SonarScan& scan) {
  if (told_) return std::nullopt;
  Sensor& sensor = sensors_[scan.sensor_id];
  const std::int64_t behind = returns_behind(scan, heard_);
  const auto returns = static_cast<double>(scan.returns.size());
  const bool several = static_cast<double>(behind) > kLeastShare * returns;
  sensor.seen[sensor.count++ % kScans] = {several, returns};
  const auto habit =
      std::count_if(sensor.seen.begin(), sensor.seen.end(), [](const Seen& s) { return s.several; });
  if (sensor.count < kScans || habit < kFewest) return std::nullopt;
  told_ = true;
  double sum = 0.0;
  for (const Seen& seen : sensor.seen) sum += seen.returns;
  return sum / kScans;
}

}  // namespace lookout::tracking
