#include "tracking/initiation/lines/line_track.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// Three scans along y = 0; the second also holds a plot at y = 1.
PlotWindow three_scans() {
  PlotWindow window;
  Plot plot;
  for (int k = 0; k < 3; ++k) {
    window.begin_scan(k);
    plot.position = {10.0 * k, 0.0};
    window.add(plot);
    plot.position.y() = 1.0;
    if (k == 1) window.add(plot);
  }
  return window;
}

const NormalLine kAxis{0.0, 1.5707963267948966};

TEST(LineTrack, TakesTheNearestOfEqualsAndTheStrongestOtherwise) {
  const PlotWindow window = three_scans();
  LineTrackBuilder builder;
  StartedTracks started;
  for (int plot = 0; plot < 4; ++plot) builder.add(plot, 1.0);
  ASSERT_TRUE(builder.build(window, kAxis, 3, MotionModelParams{0.0}, 1.0, started));
  EXPECT_EQ(started.plots, (std::vector<int>{0, 1, 3}));
  builder.add(2, 0.5);  // votes of one plot add up
  ASSERT_TRUE(builder.build(window, kAxis, 3, MotionModelParams{0.0}, 1.0, started));
  EXPECT_EQ(builder.chosen()[1], 2);
}

TEST(LineTrack, TooFewScansAreNoTrack) {
  LineTrackBuilder builder;
  StartedTracks started;
  builder.add(1, 1.0);
  builder.add(2, 1.0);
  EXPECT_FALSE(builder.build(three_scans(), kAxis, 2, MotionModelParams{0.0}, 1.0, started));
  EXPECT_TRUE(started.tracks.empty());
}

}  // namespace
}  // namespace lookout::tracking
