#include "core/field_of_view.hpp"

#include <gtest/gtest.h>

namespace lookout::core {
namespace {

TEST(FieldOfView, SeesAPointAheadOfATurnedSonar) {
  const SonarParams params;
  // Sonar at (10, 0) looking east: a point 20 m east of it lies dead ahead, between beams 44 and 45.
  const SonarPoint point = observe(params, {10.0, 0.0, radians(90.0)}, {9.9, 20.0});
  EXPECT_NEAR(point.range, 20.0, 1e-3);
  EXPECT_EQ(point.beam, 45);  // slightly to starboard (south of the axis)
  EXPECT_TRUE(point.visible());
}

TEST(FieldOfView, OutsideSectorOrRangeIsNotVisible) {
  const SonarParams params;
  EXPECT_FALSE(observe(params, {0, 0, 0}, {-10.0, 0.0}).visible());
  EXPECT_FALSE(observe(params, {0, 0, 0}, {150.1, 0.0}).visible());
  EXPECT_TRUE(observe(params, {0, 0, 0}, {149.9, 0.0}).visible());
}

TEST(FieldOfView, GeometryOfTheScanWins) {
  SonarScan scan;
  scan.num_beams = 10;
  scan.max_range = 42.0;
  SonarParams params;
  params.range_sigma = 7.0;
  const SonarParams result = with_geometry_of(scan, params);
  EXPECT_EQ(result.num_beams, 10);
  EXPECT_EQ(result.max_range, 42.0);
  EXPECT_EQ(result.range_sigma, 7.0);
}

}  // namespace
}  // namespace lookout::core
