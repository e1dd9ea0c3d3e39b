#include "tracking/track_before_detect/images/peak_tracker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lookout::tracking {
namespace {

IntensityFrame one_bright_cell(int column, int row) {
  IntensityFrame frame{60, 40, std::vector<double>(2400, 1.0)};
  frame.values[frame.index(column, row)] = 20.0;
  return frame;
}

TEST(PeakTracker, ConfirmsAfterFourHitsAndEndsAfterFiveMisses) {
  for (const auto& params : {matched_filter_baseline(), cfar_baseline()}) {
    PeakTracker tracker(params);
    const PixelGeometry geometry(60, 40);
    EXPECT_FALSE(tracker.update(one_bright_cell(20, 20), geometry, 0.0).at(0).confirmed);
    tracker.update(one_bright_cell(21, 20), geometry, 1.0);
    EXPECT_FALSE(tracker.update(one_bright_cell(22, 20), geometry, 2.0).at(0).confirmed);
    EXPECT_TRUE(tracker.update(one_bright_cell(23, 20), geometry, 3.0).at(0).confirmed);
    const IntensityFrame empty{60, 40, std::vector<double>(2400, 1.0)};
    for (int t = 4; t < 8; ++t) EXPECT_EQ(tracker.update(empty, geometry, t).size(), 1u);
    EXPECT_TRUE(tracker.update(empty, geometry, 8.0).empty());
  }
}

/// Largest distance of the baseline's track from a clear blob that creeps across the cells, without noise.
Eigen::Vector2d largest_error(bool between_cells) {
  PeakTrackerParams params = matched_filter_baseline();
  params.between_cells = between_cells;
  params.acceleration_density = 100.0;  // so that the track is where the last peak is
  PeakTracker tracker(params);
  Eigen::Vector2d largest{0, 0};
  for (int t = 0; t < 12; ++t) {
    const Eigen::Vector2d place(20.0 + 0.17 * t, 20.0 + 0.13 * t);
    IntensityFrame frame{60, 40, std::vector<double>(2400, 1.0)};
    for (int row = 0; row < frame.rows; ++row)
      for (int column = 0; column < frame.columns; ++column) {
        const Eigen::Array2d u =
            (Eigen::Vector2d(column + 0.5, row + 0.5) - place).array() / Eigen::Array2d(1.1, 0.75);
        frame.values[frame.index(column, row)] += 10.0 * std::exp(-0.5 * u.square().sum());
      }
    const auto& tracks = tracker.update(frame, PixelGeometry(60, 40), t);
    largest = largest.cwiseMax((tracks.at(0).state.head<2>() - place).cwiseAbs());
  }
  return largest;
}

// A rival that reports whole cells is off by up to half of one, and weaker than it need be.
TEST(PeakTracker, ReportsPlacesBetweenTheCells) {
  EXPECT_LT(largest_error(matched_filter_baseline().between_cells).maxCoeff(), 0.12);
  EXPECT_GT(largest_error(false).minCoeff(), 0.3);
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
