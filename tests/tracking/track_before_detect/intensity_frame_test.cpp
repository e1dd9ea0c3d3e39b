#include "tracking/track_before_detect/intensity_frame.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace lookout::tracking {
namespace {

TEST(IntensityFrame, RefusesWrongSizesAndBadPixels) {
  EXPECT_THROW(check_frame({2, 2, {1, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(check_frame({0, 2, {}}), std::invalid_argument);
  EXPECT_THROW(check_frame({2, 1, {1, -0.5}}), std::invalid_argument);
  EXPECT_NO_THROW(check_frame({2, 2, {1, 2, 3, 0}}));
}

TEST(IntensityFrame, NamesTheCellThatIsNotANumber) {
  IntensityFrame frame{3, 2, std::vector<double>(6, 1.0)};
  frame.values[frame.index(2, 1)] = std::numeric_limits<double>::quiet_NaN();
  try {
    check_frame(frame);
    FAIL() << "a NaN passed";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("(column 2, row 1)"), std::string::npos) << error.what();
  }
}

TEST(IntensityFrame, RefusesEveryKindOfDamageAndTakesEveryKindOfNumber) {
  using Limits = std::numeric_limits<double>;
  for (const double bad : {Limits::quiet_NaN(), -Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(),
                           -1.0, -Limits::denorm_min(), Limits::lowest()})
    EXPECT_THROW(check_frame({3, 1, {1.0, bad, 1.0}}), std::invalid_argument) << bad;
  for (const double good : {0.0, -0.0, Limits::denorm_min(), Limits::min(), Limits::max()})
    EXPECT_NO_THROW(check_frame({3, 1, {1.0, good, 1.0}})) << good;
}

TEST(IntensityFrame, ChecksTheCellsOfAWindowAlone) {
  IntensityFrame frame{4, 4, std::vector<double>(16, 1.0)};
  frame.values[frame.index(3, 2)] = -1.0;
  EXPECT_NO_THROW(check_cells(frame, {0, 3, 0, 4}, 1));
  EXPECT_NO_THROW(check_cells(frame, {0, 4, 1, 4}, 2));  // Rows 1 and 3.
  EXPECT_THROW(check_cells(frame, {0, 4, 0, 4}, 2), std::invalid_argument);
  EXPECT_NO_THROW(check_frame_shape(frame));
}

TEST(IntensityFrame, ThresholdIsTenLogTen) {
  EXPECT_DOUBLE_EQ(displayed_threshold(2.0, 10.0), 20.0);
  EXPECT_DOUBLE_EQ(displayed_threshold(2.0, 0.0), 2.0);
}

TEST(IntensityFrame, CollectsWhatIsAboveTheThresholdInsideTheWindow) {
  IntensityFrame frame{20, 4, std::vector<double>(80, 1.0)};
  for (const auto& [column, row] : {std::pair{0, 0}, {9, 1}, {19, 1}, {18, 3}})
    frame.values[frame.index(column, row)] = 5.0;
  std::vector<DisplayedCell> cells;
  collect_displayed(frame, 4.0, {0, 20, 0, 4}, 1, cells);
  EXPECT_EQ(cells.size(), 4u);
  collect_displayed(frame, 4.0, {1, 19, 1, 3}, 1, cells);
  ASSERT_EQ(cells.size(), 1u);
  EXPECT_EQ(cells[0].column, 9);
  EXPECT_EQ(cells[0].row, 1);
  collect_displayed(frame, 4.0, {0, 20, 1, 4}, 2, cells);  // rows 1 and 3
  EXPECT_EQ(cells.size(), 3u);
  collect_displayed(frame, 5.0, {0, 20, 0, 4}, 1, cells);  // strictly above
  EXPECT_TRUE(cells.empty());
}

TEST(IntensityFrame, MedianOfOddAndNone) {
  EXPECT_EQ(median_of({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median_of({}), 0.0);
}

}  // namespace
}  // namespace lookout::tracking
