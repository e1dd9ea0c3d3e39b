#include "tracking/track_before_detect/images/scale_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

constexpr double kThreshold = 1.9;
const Eigen::Vector2d kCell(0.1, 0.01);

/// Rayleigh noise with one blob of the given standard deviations about (160, 60).
IntensityFrame frame_with_blob(const Eigen::Vector2d& sigma, double amplitude, std::uint64_t seed) {
  core::Random random(seed);
  IntensityFrame frame{320, 120, {}};
  for (int row = 0; row < frame.rows; ++row)
    for (int column = 0; column < frame.columns; ++column) {
      const Eigen::Array2d u = Eigen::Array2d(column + 0.5 - 160.0, row + 0.5 - 60.0) / sigma.array();
      const double signal = amplitude * std::exp(-0.5 * u.square().sum());
      frame.values.push_back(std::hypot(signal + random.gaussian(), random.gaussian()));
    }
  return frame;
}

TEST(ScaleSpace, ABlobIsFoundOnceAndInTheScaleOfItsSignature) {
  for (const int pool : {1, 2, 4}) {
    ScaleSpace scales({}, kThreshold);
    const Eigen::Vector2d sigma = pool * Eigen::Vector2d(1.1, 0.75);
    std::vector<Candidate> found;
    scales.apply(frame_with_blob(sigma, 8.0, 1000), kCell, {});
    scales.find(0.01, 64, found);
    ASSERT_GE(found.size(), 1u);
    EXPECT_LT((found[0].cell - Eigen::Vector2d(160.0, 60.0)).norm(), 1.0 + pool);
    EXPECT_LT((scales.signature(static_cast<std::size_t>(found[0].scale)).array() / sigma.array())
                  .log()
                  .abs()
                  .maxCoeff(),
              std::log(2.1));  // the scales stand a factor 2 apart
    for (std::size_t i = 1; i < found.size(); ++i)
      EXPECT_GT((found[i].cell - found[0].cell).norm(), 4.0 * sigma.minCoeff());
  }
}

TEST(ScaleSpace, AKnownSignatureLeavesTheScaleNearestToIt) {
  ScaleSpaceParams params;
  params.signature = {0.44, 0.015};  // 4.4 columns and 1.5 rows: four and two cells to one
  ScaleSpace scales(params, kThreshold);
  scales.apply(frame_with_blob({1.0, 1.0}, 0.0, 1001), kCell, {});
  ASSERT_EQ(scales.scales().size(), 1u);
  EXPECT_EQ(scales.scales()[0].scale, (CellScale{4, 2}));
}

/// The frame with a ridge of rows 59 to 61, as far above the rest as a blob's flank.
IntensityFrame with_ridge(IntensityFrame frame) {
  for (int column = 0; column < frame.columns; ++column)
    for (int row = 59; row < 62; ++row) frame.values[frame.index(column, row)] += 5.0;
  return frame;
}

TEST(ScaleSpace, APeakOnARidgeIsLessThanTheSameInTheOpen) {
  const IntensityFrame open = frame_with_blob({1.1, 0.75}, 8.0, 1002), ridge = with_ridge(open);
  ScaleSpace a({}, kThreshold), b({}, kThreshold);
  std::vector<Candidate> in_open, on_ridge;
  a.apply(open, kCell, {});
  b.apply(ridge, kCell, {});
  a.find(5.0, 1, in_open);
  b.find(5.0, 1, on_ridge);
  ASSERT_FALSE(in_open.empty());
  ASSERT_FALSE(on_ridge.empty());
  EXPECT_LT(in_open[0].log_probability, on_ridge[0].log_probability);
}

/// ln of the probability of cell (160, 60) in the finest scale, where the blob is if there is one.
double middle_of(const IntensityFrame& frame) {
  ScaleSpace scales({}, kThreshold);
  scales.apply(frame, kCell, {});
  return scales.cell_log_probability(scales.scales()[0], 160, 60);
}

// Without the ridge's own level the cell of a bare ridge is as improbable as a target of the ridge's height.
TEST(ScaleSpace, ACellOfARidgeIsNoneOfATarget) {
  const IntensityFrame noise = frame_with_blob({1.1, 0.75}, 0.0, 1003);
  const IntensityFrame blob = frame_with_blob({1.1, 0.75}, 8.0, 1003);
  EXPECT_LT(middle_of(blob), -8.0);
  EXPECT_GT(middle_of(with_ridge(noise)), -3.0);
  EXPECT_GT(middle_of(with_ridge(blob)), middle_of(blob));
}

/// Share of the cells among the best e^-2 that are judged as in the open.
double share_in_the_open(const IntensityFrame& frame) {
  ScaleSpace scales({}, kThreshold);
  scales.apply(frame, kCell, {});
  const ScaledFrame& finest = scales.scales()[0];
  int bright = 0, open = 0;
  for (int row = 8; row < frame.rows - 8; ++row)
    for (int column = 8; column < frame.columns - 8; ++column) {
      const double alone = finest.cells.log_probability(finest.filter.at(column, row));
      if (alone > -2.0) continue;
      ++bright;
      open += scales.cell_log_probability(finest, column, row) == alone ? 1 : 0;
    }
  return static_cast<double>(open) / bright;
}

// Of four pairs of opposite places one has by chance more in common than the median of that in one half of
// the cells. Judged against all that is above 0, (1 - 1/4)^4 = .32 of them would be left in the open.
TEST(ScaleSpace, WhatNoiseHasEitherSideIsNoRidge) {
  EXPECT_NEAR(share_in_the_open(frame_with_blob({1.1, 0.75}, 0.0, 1005)), 0.5, 0.06);
}

// A column of the frame, as a wall that leaves the fan: its last cells have a neighbour on one side alone.
TEST(ScaleSpace, ARidgeEndsAtTheBorderOfTheFrame) {
  IntensityFrame wall = frame_with_blob({1.1, 0.75}, 0.0, 1004);
  for (int column = 159; column < 162; ++column)
    for (int row = 0; row < wall.rows; ++row) wall.values[wall.index(column, row)] += 5.0;
  ScaleSpace scales({}, kThreshold);
  scales.apply(wall, kCell, {});
  const ScaledFrame& finest = scales.scales()[0];
  EXPECT_GT(scales.cell_log_probability(finest, 160, 1), -3.0);
  EXPECT_GT(scales.cell_log_probability(finest, 160, wall.rows - 2), -3.0);
}

TEST(ScaleSpace, WhatGlittersFromFrameToFrameComesToTheLevelOfTheRest) {
  ScaleSpace scales({}, kThreshold);
  double first = 0.0, last = 0.0;
  for (std::uint64_t k = 0; k < 30; ++k) {
    scales.apply(frame_with_blob({1.1, 0.75}, 12.0, 1010 + k), kCell, {});
    const double now = scales.scales()[0].block_maximum_at({160.0, 60.0});
    if (k == 0) first = now;
    last = now;
    scales.learn({});
  }
  EXPECT_LT(last, 0.3 * first);
}

TEST(ScaleSpace, RefusesParametersOutOfRange) {
  ScaleSpaceParams params;
  params.fewest_cells = 0;
  EXPECT_THROW(ScaleSpace(params, kThreshold), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
