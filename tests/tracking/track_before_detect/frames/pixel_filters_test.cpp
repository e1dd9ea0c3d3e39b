#include "tracking/track_before_detect/frames/pixel_filters.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// Seven columns, five rows, one pixel of 9 at (2, 1).
std::vector<double> point() {
  std::vector<double> grey(35, 0.0);
  grey[7 + 2] = 9.0;
  return grey;
}

TEST(PixelFilters, TheMirrorRepeatsNoBorderPixel) {
  EXPECT_EQ(mirrored(-1, 5), 1);
  EXPECT_EQ(mirrored(5, 5), 3);
  EXPECT_EQ(mirrored(-9, 5), 1);
  EXPECT_EQ(mirrored(7, 1), 0);
}

TEST(PixelFilters, ABlurKeepsAFlatFrameAndASum) {
  for (const double value : gaussian_blur(std::vector<double>(35, 4.0), 7, 5, 1.2))
    EXPECT_NEAR(value, 4.0, 1e-12);
  const auto blurred = gaussian_blur(point(), 7, 5, 0.6);
  EXPECT_GT(blurred[9], blurred[8]);
  EXPECT_NEAR(blurred[8], blurred[10], 1e-12);  // about (2, 1) it is even
}

TEST(PixelFilters, ABoxHoldsTheSumOfItsPixels) {
  const auto sums = box_sums(point(), 7, 5, 1);
  EXPECT_DOUBLE_EQ(sums[9], 9.0);
  EXPECT_DOUBLE_EQ(sums[7 * 2 + 3], 9.0);
  EXPECT_DOUBLE_EQ(sums[7 * 3 + 3], 0.0);
  EXPECT_DOUBLE_EQ(box_sums(std::vector<double>(35, 1.0), 7, 5, 2)[0], 25.0);
}

TEST(PixelFilters, APeakIsTheCentreOfItsPixel) {
  const auto peaks = pixel_peaks(point(), 7, 5, 10);
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_EQ(peaks[0].x, 2.5);
  EXPECT_EQ(peaks[0].y, 1.5);
  EXPECT_EQ(peaks[0].value, 9.0);
}

}  // namespace
}  // namespace lookout::tracking
