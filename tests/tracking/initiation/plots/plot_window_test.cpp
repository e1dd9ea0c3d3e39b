#include "tracking/initiation/plots/plot_window.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace lookout::tracking {
namespace {

Plot at(double x, double y) {
  Plot plot;
  plot.position = {x, y};
  return plot;
}

TEST(PlotWindow, KeepsScansApartAndDropsTheOldest) {
  PlotWindow window;
  window.begin_scan(0.0);
  window.add(at(1, 2));
  window.begin_scan(1.0);
  window.begin_scan(2.0);
  window.add(at(3, 4));
  window.add(at(5, 6));
  EXPECT_EQ(window.size(1), 0);
  EXPECT_EQ(window.plot(2).scan, 2);
  window.drop_oldest_scan();
  EXPECT_EQ(window.num_scans(), 2);
  EXPECT_EQ(window.num_plots(), 2);
  EXPECT_EQ(window.plot(0).scan, 1);
  EXPECT_DOUBLE_EQ(window.plot(0).time, 2.0);
  EXPECT_EQ(window.scan(1).size(), 2u);
}

TEST(PlotWindow, RefusesTimeThatStandsStillAndPositionsThatAreNone) {
  PlotWindow window;
  EXPECT_THROW(window.add(at(0, 0)), std::invalid_argument);
  window.begin_scan(1.0);
  EXPECT_THROW(window.begin_scan(1.0), std::invalid_argument);
  EXPECT_THROW(window.add(at(std::numeric_limits<double>::quiet_NaN(), 0)), std::invalid_argument);
}

TEST(PlotWindow, CoveredAreaOfABoxAndOfAThinOne) {
  PlotWindow window;
  window.begin_scan(0.0);
  window.add(at(-10, 0));
  window.add(at(30, 20));
  EXPECT_DOUBLE_EQ(covered_area(window), 800.0);  // 40 by 20
  EXPECT_DOUBLE_EQ(largest_distance(window), std::sqrt(1300.0));
  PlotWindow row;
  row.begin_scan(0.0);
  row.add(at(0, 0));
  row.add(at(40, 0));
  EXPECT_DOUBLE_EQ(covered_area(row), 400.0);  // counted a quarter as wide as long
}

}  // namespace
}  // namespace lookout::tracking
