#include "tracking/metrics/trajectories.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

TEST(TrajectorySet, KnowsWhereEachIsAndWhereItIsNot) {
  TrajectorySet set;
  set.next_time();
  set.add(7, {1, 2});
  set.next_time();
  set.next_time();
  set.add(7, {3, 4});
  set.next_time();
  const Trajectory& trajectory = set.by_id().at(7);
  EXPECT_EQ(set.num_times(), 4u);
  EXPECT_EQ(TrajectorySet::at(trajectory, 0), Eigen::Vector2d(1, 2));
  EXPECT_FALSE(TrajectorySet::at(trajectory, 1));
  EXPECT_EQ(TrajectorySet::at(trajectory, 2), Eigen::Vector2d(3, 4));
  EXPECT_FALSE(TrajectorySet::at(trajectory, 3));
}

}  // namespace
}  // namespace lookout::tracking
