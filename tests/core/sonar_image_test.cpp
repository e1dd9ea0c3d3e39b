#include "core/sonar_image.hpp"

#include <gtest/gtest.h>

namespace lookout::core {
namespace {

SonarImage three_beams() {
  SonarImage image;
  image.bearings = {-0.1, 0.0, 0.2};
  image.num_bins = 2;
  image.intensity = {1, 2, 3, 4, 5, 6};
  return image;
}

TEST(SonarImage, FromStarboardItIsTheSamePicture) {
  SonarImage image = three_beams();
  image.bearings = {0.2, 0.0, -0.1};
  image.intensity = {5, 6, 3, 4, 1, 2};
  count_from_port(image);
  EXPECT_EQ(image.bearings, three_beams().bearings);
  EXPECT_EQ(image.intensity, three_beams().intensity);
  count_from_port(image);
  EXPECT_EQ(image.bearings, three_beams().bearings);
}

TEST(SonarImage, QuantisedItHoldsWholeSteps) {
  SonarImage image = three_beams();
  image.intensity = {0.0, 1.0, 2.4, 2.6, -10.0, 4.0};
  quantise(image, 10.0);
  EXPECT_EQ(image.intensity_scale, 1.0);
  EXPECT_EQ(image.intensity, (std::vector<double>{0, 1, 2, 3, -10, 4}));
  image.intensity.assign(6, 0.0);
  quantise(image, 10.0);
  EXPECT_EQ(image.intensity_scale, 1.0);
}

}  // namespace
}  // namespace lookout::core
