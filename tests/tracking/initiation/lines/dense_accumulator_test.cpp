#include "tracking/initiation/lines/dense_accumulator.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// Three points of the line y = 7 m: theta 90 degrees, rho 7 m.
TEST(DenseAccumulator, PointsOfALineMeetInOneCell) {
  const LineGrid grid(181, 40, 20.0);
  DenseAccumulator votes;
  ColumnVoting voting;
  votes.reset(grid);
  for (const double x : {-9.0, 1.0, 12.0}) voting.vote(grid, {x, 7.2}, votes);
  EXPECT_EQ(votes.most(), 3);
  EXPECT_EQ(votes.votes(grid, grid.cell_of({7.2, 1.5708})), 3);
  std::vector<LineVote> found;
  votes.collect(grid, 3, 100, found);
  EXPECT_TRUE(votes.is_local_maximum(grid, found.front()));
  for (const LineVote& peak : found) EXPECT_NEAR(grid.centre(peak.cell).theta, 1.5708, 0.08);
}

TEST(DenseAccumulator, LeavesOutWhatLiesOffTheGridAndForgets) {
  const LineGrid grid(4, 4, 2.0);
  DenseAccumulator votes;
  ColumnVoting voting;
  votes.reset(grid);
  voting.vote(grid, {100.0, 100.0}, votes);  // rho is within 2 m in no column but that of 135 degrees.
  EXPECT_LE(votes.most(), 1);
  votes.reset(grid);
  EXPECT_EQ(votes.most(), 0);
}

}  // namespace
}  // namespace lookout::tracking
