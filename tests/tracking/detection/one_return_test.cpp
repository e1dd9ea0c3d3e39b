#include "tracking/detection/one_return.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/tracking/detection/planes.hpp"

namespace lookout::tracking {
namespace {

using lookout::testing::flat;
using lookout::testing::set;

/// The peaks that are left of two.
std::vector<PlanePeak> left(ImagePlane& plane, const PlanePeak& a, const PlanePeak& b) {
  set(plane, a.beam, a.bin, a.value);
  set(plane, b.beam, b.bin, b.value);
  std::vector<PlanePeak> peaks{a, b};
  leave_one_peak_an_echo(plane, {1.0, 1.0}, {}, peaks);
  return peaks;
}

TEST(OneReturn, TwoEchoesWithAValleyAreTwoTheStrongestFirst) {
  ImagePlane plane = flat(9, 40);
  const auto peaks = left(plane, {4, 10, 50.0F}, {4, 20, 60.0F});
  ASSERT_EQ(peaks.size(), 2U);
  EXPECT_EQ(peaks[0].bin, 20);
  EXPECT_EQ(peaks[1].bin, 10);
}

// 6 dB, a factor of 4, is the least valley.
TEST(OneReturn, AShallowValleyMakesThemOne) {
  ImagePlane plane = flat(9, 40, 20.0F);
  EXPECT_EQ(left(plane, {4, 10, 50.0F}, {4, 20, 60.0F}).size(), 1U);
  plane = flat(9, 40, 12.0F);
  EXPECT_EQ(left(plane, {4, 10, 50.0F}, {4, 20, 60.0F}).size(), 2U);
}

// The envelope 5 dB down at one width falls with the square: at 3 widths it is 10^-0.5 / 9 = -14.5 dB.
TEST(OneReturn, APeakUnderTheSidelobesOfAStrongEchoIsNone) {
  ImagePlane plane = flat(9, 40);
  EXPECT_EQ(left(plane, {2, 10, 1000.0F}, {5, 10, 30.0F}).size(), 1U);
  plane = flat(9, 40);
  EXPECT_EQ(left(plane, {2, 10, 1000.0F}, {5, 10, 40.0F}).size(), 2U);
}

TEST(OneReturn, SidelobesLieAtTheEchosRange) {
  ImagePlane plane = flat(9, 40);
  EXPECT_EQ(left(plane, {2, 10, 1000.0F}, {5, 13, 20.0F}).size(), 2U);
}

TEST(OneReturn, APeakOnTheFlankOfAnAbsorbedPeakIsAbsorbedToo) {
  ImagePlane plane = flat(3, 60);
  for (int bin = 10; bin <= 40; ++bin) set(plane, 1, bin, 30.0F);
  set(plane, 1, 10, 100.0F);
  set(plane, 1, 25, 60.0F);
  set(plane, 1, 40, 50.0F);
  std::vector<PlanePeak> peaks{{1, 40, 50.0F}, {1, 10, 100.0F}, {1, 25, 60.0F}};
  leave_one_peak_an_echo(plane, {1.0, 1.0}, {}, peaks);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_EQ(peaks[0].bin, 10);
}

TEST(OneReturn, NoPeaksStayNone) {
  std::vector<PlanePeak> peaks;
  leave_one_peak_an_echo(flat(3, 3), {1.0, 1.0}, {}, peaks);
  EXPECT_TRUE(peaks.empty());
}

}  // namespace
}  // namespace lookout::tracking
