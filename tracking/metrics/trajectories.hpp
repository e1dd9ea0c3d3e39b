#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace lookout::tracking {

/// One target or track over the times of a run: where it is at each, nothing where it is not.
using Trajectory = std::vector<std::optional<Eigen::Vector2d>>;

/// The trajectories of a run, by identity.
class TrajectorySet {
 public:
  /// Begins the next time; all that is added belongs to it.
  void next_time();
  /// @pre a time has begun. The last position of an identity at a time counts.
  void add(std::int64_t id, const Eigen::Vector2d& position);

  std::size_t num_times() const { return num_times_; }  ///< Times begun so far.
  /// All trajectories, each as long as its last time needs.
  const std::map<std::int64_t, Trajectory>& by_id() const { return by_id_; }
  /// The trajectory at `time`; nothing beyond its end.
  static std::optional<Eigen::Vector2d> at(const Trajectory& trajectory, std::size_t time) {
    return time < trajectory.size() ? trajectory[time] : std::nullopt;
  }

 private:
  std::map<std::int64_t, Trajectory> by_id_;  // Each as long as its last time needs.
  std::size_t num_times_ = 0;
};

}  // namespace lookout::tracking
