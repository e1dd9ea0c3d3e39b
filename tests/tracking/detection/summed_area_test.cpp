#include "tracking/detection/summed_area.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/detection/planes.hpp"

namespace lookout::tracking {
namespace {

TEST(SummedArea, SumsBoxesAndClipsThem) {
  ImagePlane plane = lookout::testing::flat(3, 4);
  for (std::size_t i = 0; i < plane.values.size(); ++i) plane.values[i] = static_cast<float>(i);
  SummedArea area;
  area.prepare(plane);
  const CellSum inside = area.over({1, 3, 1, 3});  // 5 + 6 + 9 + 10
  EXPECT_EQ(inside.sum, 30.0);
  EXPECT_EQ(inside.cells, 4.0);
  const CellSum clipped = area.over({-5, 1, 2, 99});  // 2 + 3
  EXPECT_EQ(clipped.sum, 5.0);
  EXPECT_EQ(clipped.cells, 2.0);
  EXPECT_EQ(area.over({5, 9, 0, 4}).cells, 0.0);
  EXPECT_EQ(area.over({2, 1, 0, 4}).mean(), 0.0);
}

TEST(SummedArea, SumsAddAndSubtract) {
  const CellSum a{10.0, 4.0}, b{3.0, 1.0};
  EXPECT_DOUBLE_EQ((a - b).mean(), 7.0 / 3.0);
  EXPECT_DOUBLE_EQ((a + b).mean(), 13.0 / 5.0);
}

}  // namespace
}  // namespace lookout::tracking
