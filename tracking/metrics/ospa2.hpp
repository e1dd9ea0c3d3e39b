#pragma once

#include "tracking/metrics/ospa.hpp"
#include "tracking/metrics/trajectories.hpp"

namespace lookout::tracking {

/// Times [first, last] of a run, by index, both included.
struct TimeWindow {
  std::size_t first = 0;  ///< Its first time.
  std::size_t last = 0;   ///< Its last time, >= first.
};

/// The OSPA(2) distance of two sets of trajectories over a window: the OSPA distance of the sets, where the
/// distance of two trajectories is the mean, over the times at which at least one of them is, of their
/// distance, cut off, or of the cut-off where only one is. A track broken in two, or one that changes
/// targets, costs what plain OSPA does not see. Trajectories that are nowhere in the window do not count.
/// [Beard2020], its track metric with equal weights.
class Ospa2 {
 public:
  /// @throws std::invalid_argument as Ospa.
  explicit Ospa2(const OspaParams& params = {}) : ospa_(params) {}

  OspaResult operator()(const TrajectorySet& truth, const TrajectorySet& estimate, const TimeWindow& window);

 private:
  double distance(const Trajectory& a, const Trajectory& b, const TimeWindow& window) const;

  Ospa ospa_;
};

}  // namespace lookout::tracking
