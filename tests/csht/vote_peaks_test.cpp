#include "csht/vote_peaks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lookout::csht {
namespace {

// max(.4 x 10, 1.5, 2 + .5 sqrt 2) = 4; with a peak of 4 it is 2 + .707; with weak votes the floor.
TEST(PrimaryThreshold, IsTheLargestOfItsReadings) {
  const PrimaryThresholdParams params;
  EXPECT_DOUBLE_EQ(primary_threshold(params, {10.0, 2.0, 100}), 4.0);
  EXPECT_DOUBLE_EQ(primary_threshold(params, {4.0, 2.0, 100}), 2.0 + 0.5 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(primary_threshold(params, {2.0, 0.5, 100}), 1.5);
}

TEST(PrimaryThreshold, RefusesAShareThatNoCellExceeds) {
  PrimaryThresholdParams params;
  EXPECT_NO_THROW(params.validate());
  params.peak_share = 1.0;
  EXPECT_THROW(params.validate(), std::invalid_argument);
}

TEST(StrongestApart, SkipsCellsNearAStrongerPeak) {
  const HoughGrid grid{0.5, 1.0, 2.0, 100.0};
  std::vector<VoteCell> cells{{0.0, 0.0, 5.0}, {0.5, 1.0, 9.0}, {0.5, 4.0, 7.0}, {0.0, 20.0, 1.0}};
  sort_by_votes(cells);
  std::vector<VoteCell> peaks;
  strongest_apart(cells, grid, 3.0, 12, peaks);
  ASSERT_EQ(peaks.size(), 3U);  // (0, 0) is sqrt 2 steps from the strongest, (.5, 4) is three
  EXPECT_EQ(peaks[0].votes, 9.0);
  EXPECT_EQ(peaks[1].votes, 7.0);
  EXPECT_EQ(peaks[2].votes, 1.0);
  strongest_apart(cells, grid, 3.0, 2, peaks);
  EXPECT_EQ(peaks.size(), 2U);
}

}  // namespace
}  // namespace lookout::csht
