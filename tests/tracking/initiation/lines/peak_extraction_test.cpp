#include "tracking/initiation/lines/peak_extraction.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

TEST(PeakExtraction, AStrongCellRemovesItsNeighboursOnly) {
  const LineGrid grid(100, 100, 50.0);
  std::vector<LineVote> votes{{{10, 10}, 3.0}, {{11, 12}, 2.9}, {{10, 40}, 2.0}, {{60, 10}, 1.0}};
  const auto peaks = strongest_peaks(grid, {2, 2}, votes);
  ASSERT_EQ(peaks.size(), 3u);
  EXPECT_EQ(peaks[0].cell, (LineCell{10, 10}));
  EXPECT_EQ(peaks[1].cell, (LineCell{10, 40}));
  EXPECT_EQ(peaks[2].cell, (LineCell{60, 10}));
}

TEST(PeakExtraction, SuppressesOverTheWrapOfTheta) {
  const LineGrid grid(100, 100, 50.0);
  std::vector<LineVote> votes{{{0, 30}, 2.0}, {{99, 69}, 1.0}, {{99, 30}, 1.5}};
  const auto peaks = strongest_peaks(grid, {1, 1}, votes);
  ASSERT_EQ(peaks.size(), 2u);  // (99, 69) is the line of (-1, 30); (99, 30) lies on the other side.
  EXPECT_EQ(peaks[1].cell, (LineCell{99, 30}));
}

TEST(PeakExtraction, LayersAndTheBoundOfPeaks) {
  const LineGrid grid(100, 100, 50.0);
  std::vector<LineVote> votes{{{5, 5}, 3.0, 0}, {{5, 5}, 2.0, 4}, {{5, 5}, 1.0, 5}};
  EXPECT_EQ(strongest_peaks(grid, {1, 1, 1}, votes).size(), 2u);
  std::vector<LineVote> many(50);
  for (int i = 0; i < 50; ++i) many[static_cast<std::size_t>(i)].cell = {i, i};
  EXPECT_EQ(strongest_peaks(grid, {0, 0, 0, 7}, many).size(), 7u);
}

}  // namespace
}  // namespace lookout::tracking
