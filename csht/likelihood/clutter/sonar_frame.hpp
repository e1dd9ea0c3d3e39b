#pragma once

#include "csht/likelihood/clutter/frame_counts.hpp"
#include "csht/likelihood/clutter/look_memory.hpp"
#include "csht/likelihood/clutter/look_times.hpp"
#include "csht/likelihood/clutter/place_counts.hpp"

namespace lookout::csht {

/// What the returns in memory tell of a place in the sonar's frame: of what moves with the sonar. Around the
/// place all scans count but its own, for a target that moves along does not price its own returns there; at
/// the place only those long before or after, when such a target was found.
class SonarFrame {
 public:
  /// Half width of the kernel at a place.
  struct Reach {
    double beams = 3.0;  ///< Across the line of sight, > 0,
    double range = 4.0;  ///< and along it [m], > 0.
  };
  /// @param reach of the kernel.
  explicit SonarFrame(const Reach& reach) : reach_(reach) {}

  /// What is dense at a place.
  struct Found {
    TwoExcesses place;  ///< By all that counts,
    TwoExcesses clear;  ///< and where corners do not.
  };
  /// @param times those of the scan. @param rate mean number of uniform false returns of a scan, > 0.
  /// @param prior of what is dense. Cost: O(returns around the place).
  Found at(const ScanTable& scan, const SeenPlace& place, const LookMemory& memory, const LookTimes& times,
           double rate, const ExcessPrior& prior) const;

 private:
  struct Counts {
    FrameCounts all, free;   // Around,
    TwoCounts counted, far;  // and at the place.
  };
  Counts count(const SeenPlace& place, const LookMemory& memory, const LookTimes& times) const;
  double area_in_view(const ScanTable& scan, const SeenPlace& place) const;

  Reach reach_;
};

}  // namespace lookout::csht
