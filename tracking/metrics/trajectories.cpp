#include "tracking/metrics/trajectories.hpp"

#include <cassert>

namespace lookout::tracking {

void TrajectorySet::next_time() {
  ++num_times_;
}

void TrajectorySet::add(std::int64_t id, const Eigen::Vector2d& position) {
  assert(num_times_ > 0);
  Trajectory& trajectory = by_id_[id];
  trajectory.resize(num_times_);
  trajectory.back() = position;
}

}  // namespace lookout::tracking
