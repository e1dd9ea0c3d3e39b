#include "csht/joint/evidence/memory_span.hpp"

#include <algorithm>

namespace lookout::csht {

int oldest_within(double seconds, const ScanHistory& scans) {
  int oldest = 0;
  while (oldest + 1 < scans.size() && -scans.seconds_at_age(oldest + 1) <= seconds) ++oldest;
  return oldest;
}

int oldest_within(double seconds, int least_scans, const ScanHistory& scans) {
  return std::max(oldest_within(seconds, scans), std::min(least_scans, scans.size() - 1));
}

AgeSpan memory_of(const TargetTrack& track, const ScanHistory& scans, const MemorySpan& memory) {
  const bool accelerates = track.cloud.motion == Motion::constant_acceleration;
  const int most =
      accelerates ? oldest_within(memory.constant_acceleration_s, memory.constant_acceleration_scans, scans)
                  : oldest_within(memory.constant_velocity_s, scans);
  const std::int64_t since_first = scans.pushed() - 1 - track.first_scan;
  AgeSpan ages;
  ages.oldest = static_cast<int>(std::min<std::int64_t>(since_first, most));
  ages.births = track.remembers_birth && (!accelerates || since_first <= most);
  return ages;
}

}  // namespace lookout::csht
