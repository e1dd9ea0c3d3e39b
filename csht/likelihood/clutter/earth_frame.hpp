#pragma once

#include <Eigen/Core>

#include "csht/likelihood/clutter/look_memory.hpp"
#include "csht/likelihood/clutter/look_times.hpp"
#include "csht/likelihood/clutter/place_counts.hpp"

namespace lookout::csht {

/// What the returns in memory tell of a place of the earth: of what stands there. Only scans that are not
/// near in time to that at hand count.
class EarthFrame {
 public:
  /// Half width of the kernel at a place.
  struct Reach {
    double beams = 1.5;  ///< Across the line of sight [beams], > 0,
    double range = 4.0;  ///< and along it [m], > 0.
  };
  /// @param reach of the kernel.
  explicit EarthFrame(const Reach& reach) : reach_(reach) {}

  /// What is dense at a place, by the densest of three kernels: of the whole length, of a third of it, and of
  /// a third about the line that the returns lie on. @param times those of the scan. @param rate mean number
  /// of uniform false returns of a scan, > 0. @param prior of what stands. Cost: O(returns around + looks).
  TwoExcesses at(const ScanTable& scan, const SeenPlace& place, const LookMemory& memory,
                 const LookTimes& times, double rate, const ExcessPrior& prior) const;

 private:
  struct Box {  // Around a place: the line of sight, and half its length and width [m].
    Eigen::Vector2d along;
    double down = 0.0, across = 0.0;
  };
  struct Counts {
    TwoCounts wide, thin, line;
  };
  Box box_at(const ScanTable& scan, const SeenPlace& place) const;
  Counts count(const SeenPlace& place, const Box& box, const LookMemory& memory,
               const LookTimes& times) const;

  Reach reach_;
};

}  // namespace lookout::csht
