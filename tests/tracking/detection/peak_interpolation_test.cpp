#include "tracking/detection/peak_interpolation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracking/detection/planes.hpp"

namespace lookout::tracking {
namespace {

using lookout::testing::flat;
using lookout::testing::set;

/// A Gaussian echo about a place.
ImagePlane gaussian(double beam, double bin) {
  ImagePlane plane = flat(20, 30);
  for (int b = 0; b < 20; ++b)
    for (int r = 0; r < 30; ++r)
      set(plane, b, r,
          static_cast<float>(50.0 * std::exp(-0.3 * (b - beam) * (b - beam) - 0.1 * (r - bin) * (r - bin))));
  return plane;
}

// y = 5 - (x - .25)^2 at -1, 0, 1; and a straight line, which has no top.
TEST(PeakInterpolation, TheTopOfAParabola) {
  const ParabolaTop top = parabola_top(5.0 - 1.5625, 5.0 - 0.0625, 5.0 - 0.5625);
  EXPECT_NEAR(top.place, 0.25, 1e-12);
  EXPECT_NEAR(top.height, 0.0625, 1e-12);
  EXPECT_EQ(parabola_top(1.0, 2.0, 3.0).place, 0.0);
}

TEST(PeakInterpolation, IsExactForAGaussianEcho) {
  const ImagePlane plane = gaussian(9.3, 14.8);
  for (const CellReach reach : {CellReach{1, 1}, CellReach{2, 4}}) {
    const PeakPlace place = interpolate(plane, {9, 15, plane.at(9, 15), 0.0F}, reach);
    EXPECT_NEAR(place.beam, 9.3, 1e-5);
    EXPECT_NEAR(place.bin, 14.8, 1e-5);
    EXPECT_NEAR(place.gain * plane.at(9, 15), 50.0, 1e-4);
  }
}

TEST(PeakInterpolation, KeepsItsCellAtTheBorder) {
  const ImagePlane plane = gaussian(0.2, 14.8);
  const PeakPlace place = interpolate(plane, {0, 15, plane.at(0, 15), 0.0F}, {1, 1});
  EXPECT_EQ(place.beam, 0.0);
  EXPECT_NEAR(place.bin, 14.8, 1e-5);
}

TEST(PeakInterpolation, StaysWithinHalfTheReach) {
  ImagePlane plane = flat(3, 3);
  set(plane, 1, 1, 1.0001F);
  set(plane, 1, 2, 1.0001F);
  const PeakPlace place = interpolate(plane, {1, 1, 1.0001F, 0.0F}, {1, 1});
  EXPECT_LE(place.bin, 1.5);
  EXPECT_GE(place.bin, 1.0);
}

}  // namespace
}  // namespace lookout::tracking
