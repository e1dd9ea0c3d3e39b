#include "lcmtypes/convert.hpp"

#include <gtest/gtest.h>

#include "tests/lcmtypes/example_messages.hpp"

namespace lookout::lcmtypes {
namespace {

using namespace lookout::tests;

TEST(ConvertSonar, ScanThereAndBack) {
  const auto back = to_core(to_wire(example_scan())).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->utime, 2'000'000);
  EXPECT_EQ(back->sequence, 4);
  EXPECT_EQ(back->sensor_id, 7);
  EXPECT_EQ(back->T_body_sonar.north, 1.5);
  EXPECT_EQ(back->T_body_sonar.east, -0.5);
  EXPECT_EQ(back->T_body_sonar.heading, 0.125);
  EXPECT_EQ(back->first_bearing, -0.75);
  EXPECT_EQ(back->bearing_step, 0.0175);
  EXPECT_EQ(back->max_range, 150.0);
  EXPECT_EQ(back->num_beams, 90);
  ASSERT_EQ(back->returns.size(), 2u);
  EXPECT_EQ(back->returns[1].bearing, 0.25);
  EXPECT_EQ(back->returns[1].range, 120.5);
  EXPECT_EQ(back->returns[1].intensity, 0.5);
}

TEST(ConvertSonar, BeamsFromStarboardAreTheSameFanFromPort) {
  auto wire = to_wire(example_scan());  // 90 beams
  wire.first_bearing = 0.5;
  wire.bearing_step = -0.01;
  const auto scan = to_core(wire).value;
  ASSERT_TRUE(scan);
  EXPECT_DOUBLE_EQ(scan->first_bearing, 0.5 - 89 * 0.01);
  EXPECT_EQ(scan->bearing_step, 0.01);
  EXPECT_EQ(scan->returns[1].bearing, 0.25);  // Returns say where they are.
}

TEST(ConvertSonar, ImageThereAndBack) {
  const auto back = to_core(to_wire(example_image())).value;
  ASSERT_TRUE(back);
  EXPECT_EQ(back->sequence, 5);
  EXPECT_EQ(back->first_range, 1.0);
  EXPECT_EQ(back->range_step, 0.25);
  EXPECT_EQ(back->num_beams, 2);
  EXPECT_EQ(back->num_bins, 3);
  EXPECT_EQ(back->intensity, example_image().intensity);
}

TEST(ConvertSonar, ImageIntensityIsWithinHalfAStepOfTheLargest) {
  auto image = example_image();
  image.intensity = {0.1, 0.2, 0.3, 0.4, 0.5, 1.7};
  const auto back = to_core(to_wire(image)).value;
  for (std::size_t i = 0; i < image.intensity.size(); ++i)
    EXPECT_NEAR(back->intensity[i], image.intensity[i], 0.5 * 1.7 / 32767);
}

TEST(ConvertSonar, TheImageOfTheDesignFits) {  // 90 x 300 is 54,096 bytes: 96 of header, 2 a cell.
  auto image = example_image();
  image.num_beams = 90;
  image.num_bins = 300;
  image.intensity.assign(90 * 300, 0.5);
  EXPECT_EQ(encoded(to_wire(image)).size(), 54'096u);
}

}  // namespace
}  // namespace lookout::lcmtypes
