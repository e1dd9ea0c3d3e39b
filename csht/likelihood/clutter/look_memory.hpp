#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/frames.hpp"
#include "csht/likelihood/clutter/point_bins.hpp"
#include "csht/likelihood/scan_table.hpp"

namespace lookout::csht {

/// A place that a scan saw, in both frames.
struct SeenPlace {
  Eigen::Vector2d p_earth;  ///< [m].
  double beam = 0.0;        ///< Beams from the axis of the scan, to starboard.
  double range = 0.0;       ///< From its sonar [m].
};

/// Where a detection of `scan` lies. Returns of one echo are one, at their mean bearing.
SeenPlace seen_place(const ScanTable& scan, const core::Detection& detection);
/// Where a place of the earth lies around the sonar of `scan`. @param p_earth [m].
SeenPlace seen_place(const ScanTable& scan, const Eigen::Vector2d& p_earth);

/// What is kept of a scan.
struct Look {
  std::int64_t utime = 0;                 ///< Of the scan [us].
  int number = 0;                         ///< The first is 0; its points bear it.
  core::Pose2 T_earth_sonar;              ///< Then.
  double cos_axis = 1.0, sin_axis = 0.0;  ///< Of the azimuth of the middle of its fan.
  double cos_half_sector = 0.0;       ///< Of the angle from there to its outer edges; -1 of the whole circle.
  double max_range = 0.0;             ///< [m].
  std::vector<BinnedPoint> earth;     ///< Its returns, north and east [m]. Their weights are those that hold.
  std::vector<BinnedPoint> in_sonar;  ///< The same in the same order, as beam and range [range reaches].
};

/// The latest looks, and their returns in bins of the sonar's frame and of the earth's.
class LookMemory {
 public:
  /// What bounds a memory.
  struct Limits {
    std::int64_t spacing_us = 0;   ///< Scans that follow faster are not kept [us].
    std::size_t most_looks = 0;    ///< Of more the oldest go. With 0 nothing can be added.
    std::size_t most_returns = 1;  ///< Of a scan, >= 1; of more, evenly spaced ones, each for as many.
    double range_reach = 1.0;      ///< Unit of ranges, and the side of the earth's bins [m], > 0.
  };
  /// Makes all buffers at once: afterwards a scan allocates nothing.
  explicit LookMemory(const Limits& limits);

  /// Takes the newest scan, later than all before it, and sorts the returns. Cost: O(returns in memory).
  /// @return whether it was time for one.
  bool add(const ScanTable& scan);
  /// The look at a scan whose detections were all taken; null for none. What is written to its weights shows
  /// in the bins after the next `add`.
  Look* look_at(const ScanTable& scan);

  const std::vector<Look>& looks() const { return looks_; }  ///< The oldest first.
  const PointBins& earth() const { return earth_; }          ///< All returns, x north and y east [m].
  const PointBins& in_sonar() const { return in_sonar_; }    ///< All, x beams and y range [range reaches].
  std::size_t most_looks() const { return limits_.most_looks; }  ///< That there is room for.
  /// Where a point of the sonar's frame lies around the sonar of `scan`.
  SeenPlace place_around(const ScanTable& scan, const BinnedPoint& in_sonar) const;

 private:
  Look& next_look();
  void take_return(const ScanTable& scan, const core::Detection& detection, float weight, Look& look);
  void sort_returns();

  Limits limits_;
  std::vector<Look> looks_;  ///< The oldest first.
  std::vector<Look> spare_;  ///< Those not in use yet, with their buffers.
  std::vector<BinnedPoint> points_;
  PointBins earth_, in_sonar_;
};

}  // namespace lookout::csht
