#pragma once

#include <algorithm>
#include <vector>

#include "tracking/metrics/trajectories.hpp"

namespace lookout::tests {

/// A trajectory that stands at `position` over times [first, last].
struct Standing {
  std::int64_t id = 0;
  Eigen::Vector2d position{0, 0};
  int first = 0;
  int last = 0;
};

/// The pieces of one identity may be several.
inline tracking::TrajectorySet trajectories(const std::vector<Standing>& pieces, int num_times) {
  tracking::TrajectorySet set;
  for (int time = 0; time < num_times; ++time) {
    set.next_time();
    for (const auto& piece : pieces)
      if (time >= piece.first && time <= piece.last) set.add(piece.id, piece.position);
  }
  return set;
}

}  // namespace lookout::tests
