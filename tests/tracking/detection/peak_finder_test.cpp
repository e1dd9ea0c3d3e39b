#include "tracking/detection/peak_finder.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/tracking/detection/planes.hpp"

namespace lookout::tracking {
namespace {

using lookout::testing::flat;
using lookout::testing::set;

std::vector<PlanePeak> peaks_of(const ImagePlane& plane, const CellReach& reach) {
  std::vector<PlanePeak> peaks;
  find_peaks(plane, reach, peaks);
  return peaks;
}

TEST(PeakFinder, FindsTheGreatestOfItsNeighbourhood) {
  ImagePlane plane = flat(9, 20);
  set(plane, 4, 10, 5.0F);
  set(plane, 5, 11, 4.0F);  // A neighbour over the corner.
  set(plane, 4, 14, 3.0F);
  const auto peaks = peaks_of(plane, {1, 1});
  ASSERT_EQ(peaks.size(), 2U);
  EXPECT_EQ(peaks[0].beam, 4);
  EXPECT_EQ(peaks[0].bin, 10);
  EXPECT_EQ(peaks[0].value, 5.0F);
  EXPECT_EQ(peaks[1].bin, 14);
}

TEST(PeakFinder, AWiderReachLeavesFewer) {
  ImagePlane plane = flat(9, 20);
  set(plane, 4, 10, 5.0F);
  set(plane, 4, 14, 3.0F);
  EXPECT_EQ(peaks_of(plane, {1, 4}).size(), 1U);
}

TEST(PeakFinder, OfEqualsTheFirst) {
  ImagePlane plane = flat(9, 20);
  set(plane, 4, 10, 5.0F);
  set(plane, 4, 11, 5.0F);
  set(plane, 5, 10, 5.0F);
  const auto peaks = peaks_of(plane, {1, 1});
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_EQ(peaks[0].bin, 10);
  EXPECT_EQ(peaks[0].beam, 4);
}

TEST(PeakFinder, LooksAtTheBorderToo) {
  ImagePlane plane = flat(4, 6);
  set(plane, 0, 0, 2.0F);
  set(plane, 3, 5, 2.0F);
  EXPECT_EQ(peaks_of(plane, {1, 1}).size(), 2U);
}

TEST(PeakFinder, ALevelHasNoPeak) {
  EXPECT_TRUE(peaks_of(flat(4, 6), {1, 1}).empty());
}

}  // namespace
}  // namespace lookout::tracking
