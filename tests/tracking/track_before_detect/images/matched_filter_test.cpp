#include "tracking/track_before_detect/images/matched_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

IntensityFrame noise(int columns, int rows, std::uint64_t seed) {
  core::Random random(seed);
  IntensityFrame frame{columns, rows, {}};
  for (int i = 0; i < columns * rows; ++i)
    frame.values.push_back(std::hypot(random.gaussian(), random.gaussian()));
  return frame;
}

/// Share of the tiling blocks whose maximum reaches `value`, in (0, 1]: uniform for a block without target.
double rank(const MatchedFilter& filter, double value) {
  const auto tiles = filter.tiles();
  const auto reaching = tiles.end() - std::lower_bound(tiles.begin(), tiles.end(), value);
  return (static_cast<double>(reaching) + 1.0) / (static_cast<double>(tiles.size()) + 1.0);
}

TEST(MatchedFilter, KeepsTheVarianceOfWhiteNoise) {
  MatchedFilter filter;
  filter.apply(noise(300, 90, 1000));
  double sum = 0.0, squares = 0.0;
  for (int row = 5; row < 85; ++row)
    for (int column = 5; column < 295; ++column) {
      sum += filter.at(column, row);
      squares += filter.at(column, row) * filter.at(column, row);
    }
  const double n = 80.0 * 290.0, mean = sum / n;
  EXPECT_NEAR(squares / n - mean * mean, 2.0 - M_PI / 2.0,
              0.03);  // of the Rayleigh law: the kernel has unit energy
}

TEST(MatchedFilter, RanksOfBlocksWithoutTargetAreUniform) {
  MatchedFilter reference, other;
  reference.apply(noise(300, 90, 1001));
  other.apply(noise(300, 90, 1002));
  double mean = 0.0, below_tenth = 0.0;
  int count = 0;
  for (int row = 4; row < 86; row += 3)
    for (int column = 7; column < 293; column += 5, ++count) {
      const double share = rank(reference, other.block_maximum(column, row));
      mean += share;
      below_tenth += share <= 0.1 ? 1.0 : 0.0;
    }
  EXPECT_NEAR(mean / count, 0.5, 0.03);  // 1596 blocks: four standard errors are 0.029
  EXPECT_NEAR(below_tenth / count, 0.1, 0.03);
}

TEST(MatchedFilter, FindsTheOnePeakAndRanksItFirst) {
  IntensityFrame frame{100, 60, std::vector<double>(6000, 1.0)};
  frame.values[frame.index(40, 30)] = 9.0;
  MatchedFilter filter;
  filter.apply(frame);
  std::vector<FramePeak> peaks;
  filter.find_peaks(1.0, peaks);
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_EQ(peaks[0].column, 40);
  EXPECT_EQ(peaks[0].row, 30);
  EXPECT_LT(rank(filter, peaks[0].value), 0.005);  // 400 blocks, none reaches it but its own
}

// A blob half of the way to the next column and a fifth of that to the next row, as wide as the filter.
TEST(MatchedFilter, APeakLiesBetweenTheCells) {
  IntensityFrame frame{100, 60, std::vector<double>(6000, 1.0)};
  for (int row = 20; row < 40; ++row)
    for (int column = 30; column < 50; ++column) {
      const double x = (column + 0.5 - 40.9) / 1.1, y = (row + 0.5 - 30.6) / 0.75;
      frame.values[frame.index(column, row)] += 9.0 * std::exp(-0.5 * (x * x + y * y));
    }
  MatchedFilter filter;
  filter.apply(frame);
  std::vector<FramePeak> peaks;
  filter.find_peaks(3.0, peaks);
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_NEAR(filter.place_of(peaks[0]).x(), 40.9, 0.05);
  EXPECT_NEAR(filter.place_of(peaks[0]).y(), 30.6, 0.05);
  EXPECT_EQ(filter.place_of({0, 0, 1.0}), Eigen::Vector2d(0.5, 0.5));  // nothing lies beyond the corner
}

TEST(MatchedFilter, AFlatFrameRanksNothing) {
  MatchedFilter filter;
  filter.apply({50, 30, std::vector<double>(1500, 7.0)});
  EXPECT_DOUBLE_EQ(rank(filter, filter.block_maximum(20, 20)), 1.0);
}

TEST(MatchedFilter, RefusesEvenBlocks) {
  MatchedFilterParams params;
  params.block_rows = 2;
  EXPECT_THROW(MatchedFilter{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
