#include "tracking/initiation/methods/fpht.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracking/initiation/initiator_test_scene.hpp"

namespace lookout::tracking {
namespace {

double highest(const PlotWindow& window) {
  FphtInitiator method({});
  method.start(window);
  return test::votes_of(method).highest;
}

TEST(Fpht, ACellGetsTheLargestMembershipOfAScan) {
  // The same target three times over in every scan: still one vote a scan, at most 1 each.
  core::Random random(1027);
  test::SceneOptions options;
  options.scans = 4;
  const test::Course course{{1000, 2000}, {250, 0}};
  const double once = highest(test::scene_of({course}, options, random));
  EXPECT_LE(once, 4.0);
  EXPECT_GT(once, 3.0);  // Four plots within one row of 750 m of some line: e^-1/8 each at worst.
  EXPECT_FLOAT_EQ(static_cast<float>(highest(test::scene_of({course, course, course}, options, random))),
                  static_cast<float>(once));
}

TEST(Fpht, AMembershipFallsAsAGaussianOverTheRows) {
  // One plot in one scan: in each column the rows hold e^(-d^2/2), d the rows between plot and cell.
  PlotWindow window;
  Plot plot;
  plot.position = {12345.0, -6789.0};
  for (int k = 0; k < 2; ++k) window.begin_scan(5.0 * k);
  window.add(plot);
  FphtInitiator method({});
  method.start(window);
  std::vector<LineVote> cells;
  method.append_cells(cells);
  ASSERT_EQ(cells.size(), 200u * 5u);  // Columns times 2 * reach + 1 rows.
  for (const auto& cell : cells) {
    const NormalLine line = method.grid().centre(cell.cell);
    const double rows = (plot.position.dot(line.normal()) - line.rho) / 750.0;
    ASSERT_NEAR(cell.value, std::exp(-0.5 * rows * rows), 1e-6);
  }
}

TEST(Fpht, RefusesParametersOutOfRange) {
  FphtParams params;
  params.cell_sigma = 0.0;
  EXPECT_THROW(FphtInitiator{params}, std::invalid_argument);
  params = {};
  params.window_scans = 1;
  EXPECT_THROW(FphtInitiator{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
