#include "tracking/track_before_detect/images/peak_tracker.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace lookout::tracking {
namespace {

IntensityFrame one_bright_cell(int column, int row) {
  IntensityFrame frame{60, 40, std::vector<double>(2400, 1.0)};
  frame.values[frame.index(column, row)] = 20.0;
  return frame;
}

TEST(PeakTracker, ConfirmsAfterThreeHitsAndEndsAfterFiveMisses) {
  for (const auto& params : {matched_filter_baseline(), cfar_baseline()}) {
    PeakTracker tracker(params);
    const PixelGeometry geometry(60, 40);
    EXPECT_FALSE(tracker.update(one_bright_cell(20, 20), geometry, 0.0).at(0).confirmed);
    tracker.update(one_bright_cell(21, 20), geometry, 1.0);
    EXPECT_TRUE(tracker.update(one_bright_cell(22, 20), geometry, 2.0).at(0).confirmed);
    const IntensityFrame empty{60, 40, std::vector<double>(2400, 1.0)};
    for (int t = 3; t < 7; ++t) EXPECT_EQ(tracker.update(empty, geometry, t).size(), 1u);
    EXPECT_TRUE(tracker.update(empty, geometry, 7.0).empty());
  }
}

TEST(PeakTracker, TheCfarRatioIsTheCellOverItsNeighbours) {
  IntensityFrame frame{60, 1, std::vector<double>(60, 2.0)}, ratio;
  frame.values[30] = 14.0;
  cell_averaging_ratio(frame, 2, 6, ratio);
  EXPECT_DOUBLE_EQ(ratio.values[30], 7.0);
  EXPECT_DOUBLE_EQ(ratio.values[31], 1.0);                // the bright cell is inside the guard
  EXPECT_DOUBLE_EQ(ratio.values[34], 2.0 / (2.0 + 1.0));  // one of twelve references holds 14: mean 3
}

TEST(PeakTracker, RefusesParametersOutOfRange) {
  PeakTrackerParams params;
  params.confirm_window = 2;
  EXPECT_THROW(PeakTracker{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
