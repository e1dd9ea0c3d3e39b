#include "tracking/detection/image_geometry.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

ImageGeometry uneven() {
  return {{-0.3, -0.1, 0.0, 0.2}, 2.0, 0.5, 10};
}

TEST(ImageGeometry, BearingsBetweenUnevenBeams) {
  const ImageGeometry geometry = uneven();
  EXPECT_DOUBLE_EQ(geometry.bearing_at(0.0), -0.3);
  EXPECT_DOUBLE_EQ(geometry.bearing_at(0.5), -0.2);
  EXPECT_DOUBLE_EQ(geometry.bearing_at(2.25), 0.05);
  EXPECT_DOUBLE_EQ(geometry.bearing_at(3.0), 0.2);
  EXPECT_DOUBLE_EQ(geometry.spacing(), 0.5 / 3.0);
}

TEST(ImageGeometry, RangesBetweenBins) {
  EXPECT_DOUBLE_EQ(uneven().range_at(0.0), 2.0);
  EXPECT_DOUBLE_EQ(uneven().range_at(1.5), 2.75);
}

TEST(ImageGeometry, ASingleBeamHasItsBearing) {
  const ImageGeometry geometry{{0.1}, 1.0, 1.0, 5};
  EXPECT_DOUBLE_EQ(geometry.bearing_at(0.0), 0.1);
  EXPECT_DOUBLE_EQ(geometry.spacing(), core::kSingleBeamStep);
}

TEST(ImageGeometry, TakesTheImages) {
  core::SonarImage image;
  image.bearings = {-0.1, 0.02, 0.1};
  image.first_range = 1.0;
  image.range_step = 0.25;
  image.num_bins = 7;
  ImageGeometry geometry;
  copy_geometry(image, geometry);
  EXPECT_EQ(geometry.num_beams(), 3);
  EXPECT_DOUBLE_EQ(geometry.bearing_at(2.0), 0.1);
  EXPECT_EQ(geometry.num_bins, 7);
  ImageGeometry other = geometry;
  EXPECT_TRUE(other == geometry);
  other.range_step = 0.3;
  EXPECT_FALSE(other == geometry);
}

}  // namespace
}  // namespace lookout::tracking
