#include "tools/experiments/tracking/clutter_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/files/csv.hpp"
#include "core/frames.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tools/experiments/tracking/sea_scene.hpp"

namespace lookout::tools {
namespace {

// The cells of clutter_grid() for the sonar of the seas: 1.5 degrees by 3 m.
core::ClutterGrid grid_of_the_sea() {
  core::ClutterGrid grid;
  grid.first_bearing = core::radians(-45.0);
  grid.bearing_step = core::radians(1.5);
  grid.range_step = 3.0;
  grid.num_bearings = 60;
  grid.num_ranges = 50;
  grid.density.assign(3000, 0);
  return grid;
}

double times_background(const std::vector<double>& density, std::size_t row, std::size_t first_column,
                        std::size_t last_column) {
  double sum = 0.0;
  for (std::size_t column = first_column; column < last_column; ++column)
    sum += std::pow(10.0, 0.1 * density[50 * row + column]);
  return sum / static_cast<double>(last_column - first_column);
}

// Ten thousand scans have some 20 or 40 returns of the background in a cell: over 50 cells within 3 x 3 %.
TEST(ClutterPicture, TheUniformSeaIsItsBackground) {
  const auto density = true_clutter(sea_scene({"uniform", "near"}, 7, 0), 7, 0, grid_of_the_sea());
  for (const int row : {0, 20, 40, 59}) EXPECT_NEAR(times_background(density, row, 0, 50), 1.0, 0.1);
}

// .9 over 30 m and, where that is silent, the background's .1 over 150 m: (.9 / 30 + .1 x .1 / 150) / (.1 /
// 150).
TEST(ClutterPicture, APatchIsAsDenseAsItsPlanSays) {
  const auto density = true_clutter(sea_scene({"patch", "near"}, 7, 0), 7, 0, grid_of_the_sea());
  EXPECT_NEAR(times_background(density, 40, 20, 30), 45.1, 1.5);  // 15 to 16.5 degrees, 60 to 90 m
  EXPECT_NEAR(times_background(density, 40, 0, 20), 0.1,
              0.05);  // one return a beam: the patch takes the place
  EXPECT_NEAR(times_background(density, 10, 0, 50), 1.0, 0.1);
}

// What stands lies where it does in the run that the tracker had: the same again, and another in another run.
TEST(ClutterPicture, RocksLieWhereTheRunHasThem) {
  const auto grid = grid_of_the_sea();
  const auto scene = sea_scene({"rocks", "near"}, 7, 0);
  const auto first = true_clutter(scene, 7, 0, grid);
  EXPECT_EQ(first, true_clutter(scene, 7, 0, grid));
  const auto other = true_clutter(scene, 7, 1, grid);
  const auto is_rock = [](double density) { return density > 10.0; };
  const auto rocks = std::count_if(first.begin(), first.end(), is_rock);
  EXPECT_GT(rocks, 5);
  EXPECT_LT(rocks, 500);
  int both = 0;
  for (std::size_t cell = 0; cell < first.size(); ++cell)
    both += is_rock(first[cell]) && is_rock(other[cell]) ? 1 : 0;
  EXPECT_LT(both, rocks / 2);
}

TEST(ClutterPicture, WritesARowACell) {
  core::ClutterGrid grid = grid_of_the_sea();
  grid.density[51] = 12;
  std::vector<double> truth(3000, -std::numeric_limits<double>::infinity());
  truth[51] = 16.5;
  const tests::TemporaryDirectory directory;
  const std::string path = directory.file("clutter.csv");
  write_clutter(truth, {{"joint", grid}, {"gnn", grid}}, path);
  const core::CsvTable table(path, {});
  ASSERT_EQ(table.num_rows(), 3000U);
  EXPECT_TRUE(table.empty(0, "true_db"));
  EXPECT_NEAR(table.number(51, "bearing_deg"), -45.0 + 1.5 * 1.5, 1e-9);
  EXPECT_NEAR(table.number(51, "range_m"), 4.5, 1e-9);
  EXPECT_EQ(table.number(51, "true_db"), 16.5);
  EXPECT_EQ(table.number(51, "gnn_db"), 12.0);
}

}  // namespace
}  // namespace lookout::tools
