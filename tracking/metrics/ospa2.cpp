#include "tracking/metrics/ospa2.hpp"

#include <algorithm>

namespace lookout::tracking {
namespace {

/// The trajectories that are somewhere in the window.
std::vector<const Trajectory*> present(const TrajectorySet& set, const TimeWindow& window) {
  std::vector<const Trajectory*> found;
  for (const auto& [id, trajectory] : set.by_id())
    for (std::size_t time = window.first; time <= window.last; ++time)
      if (TrajectorySet::at(trajectory, time)) {
        found.push_back(&trajectory);
        break;
      }
  return found;
}

}  // namespace

double Ospa2::distance(const Trajectory& a, const Trajectory& b, const TimeWindow& window) const {
  const double cutoff = ospa_.params().cutoff;
  double sum = 0.0;
  int times = 0;
  for (std::size_t time = window.first; time <= window.last; ++time) {
    const auto p_a = TrajectorySet::at(a, time);
    const auto p_b = TrajectorySet::at(b, time);
    if (!p_a && !p_b) continue;
    ++times;
    sum += p_a && p_b ? std::min(cutoff, (*p_a - *p_b).norm()) : cutoff;
  }
  return times > 0 ? sum / times : 0.0;
}

OspaResult Ospa2::operator()(const TrajectorySet& truth, const TrajectorySet& estimate,
                             const TimeWindow& window) {
  const auto targets = present(truth, window);
  const auto tracks = present(estimate, window);
  Eigen::MatrixXd distances(static_cast<Eigen::Index>(targets.size()),
                            static_cast<Eigen::Index>(tracks.size()));
  for (std::size_t i = 0; i < targets.size(); ++i)
    for (std::size_t j = 0; j < tracks.size(); ++j)
      distances(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          distance(*targets[i], *tracks[j], window);
  return ospa_.of_distances(distances);
}

}  // namespace lookout::tracking
