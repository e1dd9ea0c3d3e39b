#pragma once

#include "csht/joint/density/target_track.hpp"
#include "csht/joint/evidence/scan_likelihood.hpp"
#include "csht/likelihood/scan_history.hpp"

namespace lookout::csht {

/// How far back a track's likelihood reaches.
struct MemorySpan {
  double line_s = 60.0;  ///< Of a line and of a turn [s].
  double bend_s = 16.0;  ///< Of a bend [s], but
  int bend_scans = 7;    ///< at least so many scans before the newest, however slowly they come.
};

/// Age of the oldest scan that is at most `seconds` older than the newest; 0 at least.
int oldest_within(double seconds, const ScanHistory& scans);

/// The same, but of so many scans before the newest at least, if there are as many.
int oldest_within(double seconds, int least_scans, const ScanHistory& scans);

/// The scans that a track remembers: since its first, as far as its motion model holds; with births while
/// its birth is among them.
AgeSpan memory_of(const TargetTrack& track, const ScanHistory& scans, const MemorySpan& memory);

}  // namespace lookout::csht
