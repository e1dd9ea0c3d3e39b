#include "tracking/detection/echo_filter.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/detection/planes.hpp"

namespace lookout::tracking {
namespace {

using lookout::testing::flat;
using lookout::testing::set;

TEST(EchoFilter, LeavesALevelAsItIs) {
  ImagePlane plane = flat(7, 20, 3.0F);
  EchoFilter().apply({3, 4}, plane);
  for (const float value : plane.values) EXPECT_NEAR(value, 3.0F, 1e-5F);
}

// Two running means of width 3 are the weights 1 2 3 2 1 over 9.
TEST(EchoFilter, IsATriangleAlongRange) {
  ImagePlane plane = flat(1, 20, 0.0F);
  set(plane, 0, 10, 9.0F);
  EchoFilter().apply({1, 3}, plane);
  const float expected[] = {0.0F, 1.0F, 2.0F, 3.0F, 2.0F, 1.0F, 0.0F};
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(plane.at(0, 7 + i), expected[i], 1e-5F);
}

// Of an even width the two means lean to opposite sides: 1 2 1 over 4, in its place.
TEST(EchoFilter, AnEvenWidthStaysInItsPlace) {
  ImagePlane plane = flat(20, 1, 0.0F);
  set(plane, 10, 0, 4.0F);
  EchoFilter().apply({2, 1}, plane);
  EXPECT_NEAR(plane.at(9, 0), 1.0F, 1e-5F);
  EXPECT_NEAR(plane.at(10, 0), 2.0F, 1e-5F);
  EXPECT_NEAR(plane.at(11, 0), 1.0F, 1e-5F);
  EXPECT_NEAR(plane.at(12, 0), 0.0F, 1e-5F);
}

TEST(EchoFilter, AWidthOfOneChangesNothing) {
  ImagePlane plane = flat(3, 3);
  set(plane, 1, 1, 5.0F);
  EchoFilter().apply({1, 1}, plane);
  EXPECT_EQ(plane.at(1, 1), 5.0F);
  EXPECT_EQ(plane.at(0, 1), 1.0F);
}

}  // namespace
}  // namespace lookout::tracking
