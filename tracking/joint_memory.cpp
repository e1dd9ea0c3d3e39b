#include "tracking/joint_memory.hpp"

#include <algorithm>

namespace lookout::tracking {

int oldest_within(double seconds, const csht::ScanHistory& scans) {
  int oldest = 0;
  while (oldest + 1 < scans.size() && -scans.seconds_at_age(oldest + 1) <= seconds) ++oldest;
  return oldest;
}

int oldest_of_bend(const JointMemory& memory, const csht::ScanHistory& scans) {
  return std::max(oldest_within(memory.bend_s, scans), std::min(memory.bend_scans, scans.size() - 1));
}

AgeSpan memory_of(const JointTrack& track, const csht::ScanHistory& scans, const JointMemory& memory) {
  AgeSpan ages;
  if (track.cloud.motion == Motion::bend) {
    ages.oldest = oldest_of_bend(memory, scans);
    return ages;
  }
  const std::int64_t since_first = scans.pushed() - 1 - track.first_scan;
  ages.oldest = static_cast<int>(std::min<std::int64_t>(since_first, oldest_within(memory.line_s, scans)));
  ages.births = track.remembers_birth;
  return ages;
}

}  // namespace lookout::tracking
