#include "tracking/initiation/plots/plot_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

TEST(PlotIndex, FindsExactlyWhatASearchOfAllFinds) {
  core::Random random(1002);
  PlotWindow window;
  window.begin_scan(0.0);
  window.add({});
  window.begin_scan(1.0);
  Plot plot;
  for (int i = 0; i < 500; ++i) {
    plot.position = {random.uniform(-50, 80), random.uniform(0, 9)};
    window.add(plot);
  }
  PlotIndex index;
  index.build(window, 1);
  for (int query = 0; query < 50; ++query) {
    const Eigen::Vector2d centre(random.uniform(-70, 100), random.uniform(-5, 15));
    const double radius = random.uniform(0.1, 30.0);
    std::vector<int> found, expected;
    index.near(centre, radius, [&](int i) {
      if ((window.plot(i).position - centre).norm() <= radius) found.push_back(i);
    });
    for (int i = 1; i < window.num_plots(); ++i)
      if ((window.plot(i).position - centre).norm() <= radius) expected.push_back(i);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

TEST(PlotIndex, HoldsCoincidingPlotsAndEmptyScans) {
  PlotWindow window;
  window.begin_scan(0.0);
  window.begin_scan(1.0);
  for (int i = 0; i < 4; ++i) window.add({});
  PlotIndex index;
  int found = 0;
  index.build(window, 0);
  index.near({0, 0}, 5.0, [&](int) { ++found; });
  EXPECT_EQ(found, 0);
  index.build(window, 1);
  index.near({0, 0}, 5.0, [&](int) { ++found; });
  EXPECT_EQ(found, 4);
}

}  // namespace
}  // namespace lookout::tracking
