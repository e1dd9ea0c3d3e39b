#pragma once

#include "csht/joint/density/target_track.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"
#include "csht/likelihood/scan_history.hpp"

namespace lookout::csht {

/// How far back a track's likelihood reaches, by its motion.
struct MemorySpan {
  double constant_velocity_s = 60.0;      ///< At constant velocity and in a constant turn [s].
  double constant_acceleration_s = 16.0;  ///< At constant acceleration [s],
  /// but at least so many scans before the newest, however slowly they come.
  int constant_acceleration_scans = 7;
};

/// Age of the oldest scan that is at most `seconds` older than the newest; 0 at least.
int oldest_within(double seconds, const ScanHistory& scans);

/// The same, but at least `least_scans`, or as many as there are.
int oldest_within(double seconds, int least_scans, const ScanHistory& scans);

/// The scans that a track's likelihood counts: from its first on, but no farther back than its motion is
/// taken to hold. `births` is set while its first scan is among them, so that its beginning is still summed
/// over.
AgeSpan memory_of(const TargetTrack& track, const ScanHistory& scans, const MemorySpan& memory);

}  // namespace lookout::csht
