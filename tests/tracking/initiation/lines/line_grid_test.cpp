#include "tracking/initiation/lines/line_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace lookout::tracking {
namespace {

/// 10 columns of 18 degrees, 8 rows of 5 m.
LineGrid small_grid() {
  return {10, 8, 20.0};
}

TEST(LineGrid, CellAndCentreAgreeEverywhere) {
  const LineGrid grid = small_grid();
  for (std::int64_t i = 0; i < grid.num_cells(); ++i) {
    EXPECT_EQ(grid.cell_of(grid.centre(grid.cell_at(i))), grid.cell_at(i));
    EXPECT_EQ(grid.index(grid.cell_at(i)), i);
  }
}

TEST(LineGrid, NegativeRhoIsOnTheGrid) {
  EXPECT_EQ(small_grid().cell_of({-19.0, 0.1}), (LineCell{0, 0}));
  EXPECT_FALSE(small_grid().contains(small_grid().cell_of({-21.0, 0.1})));
}

TEST(LineGrid, AStepOverTheEndOfThetaMirrorsRho) {
  const LineGrid grid = small_grid();
  EXPECT_EQ(grid.wrapped({-1, 2}), (LineCell{9, 5}));
  EXPECT_EQ(grid.wrapped({10, 5}), (LineCell{0, 2}));
  // The mirrored cell holds the same line: half a column beyond pi, rho of row 5 is that of row 2 flipped.
  const NormalLine apart = line_difference(
      {grid.centre({9, 5}).rho, std::numbers::pi + 0.5 * grid.theta_step()}, grid.centre({0, 2}));
  EXPECT_NEAR(apart.rho, 0.0, 1e-12);
  EXPECT_NEAR(apart.theta, 0.0, 1e-12);
}

TEST(LineGrid, DistanceTakesTheShorterWay) {
  EXPECT_EQ(cell_distance(small_grid(), {9, 5}, {0, 2}), (LineCell{1, 0}));
  EXPECT_EQ(cell_distance(small_grid(), {3, 1}, {5, 7}), (LineCell{2, 6}));
}

TEST(LineGrid, RefusesAnEmptyGrid) {
  EXPECT_THROW(LineGrid(0, 8, 20.0), std::invalid_argument);
  EXPECT_THROW(LineGrid(10, 8, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
