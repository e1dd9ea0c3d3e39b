#pragma once

#include <cstdint>
#include <vector>

#include "core/pose_history.hpp"
#include "core/sonar_scan.hpp"
#include "core/track.hpp"

namespace lookout::core {

/// An accepted scan and where the vehicle was at its time.
struct RememberedScan {
  VehicleState vehicle;  ///< At the scan's own utime.
  SonarScan scan;        ///< As it was accepted.
};

/// What a tracker needs to go on after its process was ended: the newest scans, by which any method finds its
/// targets again, and who they were. No filter's inside: it outlives a change of method or release.
struct TrackingMemory {
  std::int64_t next_id = 1;           ///< No identity from this one on was used.
  std::int64_t utime = 0;             ///< Of `tracks`, scenario time [us].
  std::vector<Track> tracks;          ///< As they were last reported.
  std::vector<RememberedScan> scans;  ///< In order of time; may be empty.
};

}  // namespace lookout::core
