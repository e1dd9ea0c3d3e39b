#include "lcmtypes/convert.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "core/beam_bearings.hpp"
#include "lcmtypes/inbox.hpp"
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
  EXPECT_EQ(back->bearings, example_image().bearings);
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

/// Of 8 bytes of fingerprint, 20 of time, sequence and sensor, 48 of mount, ranges and scale, 4 of counts.
constexpr std::size_t kHeaderBytes = 8 + 20 + 48 + 4;

core::SonarImage image_of(int beams, int bins) {
  auto image = example_image();
  image.bearings = core::even_bearings(-0.5, 1e-5, beams);
  image.num_bins = bins;
  image.intensity.assign(static_cast<std::size_t>(beams) * static_cast<std::size_t>(bins), 0.5);
  return image;
}

TEST(ConvertSonar, AnImageTakesTwoBytesAPixelAndEightABeam) {
  EXPECT_EQ(encoded(to_wire(image_of(90, 300))).size(), kHeaderBytes + 90 * 8 + 90 * 300 * 2);
}

TEST(ConvertSonar, TheLargestImagePassesThroughTheDecoder) {
  const auto bytes = encoded(to_wire(image_of(4096, 1024)));
  const auto wire = decode<sonar_image_t>(bytes.data(), bytes.size());
  ASSERT_TRUE(wire);
  const auto image = to_core(*wire).value;
  ASSERT_TRUE(image);
  EXPECT_EQ(image->intensity.size(), 4'194'304u);
  EXPECT_THROW(to_wire(image_of(4097, 1024)), std::length_error);
}

TEST(ConvertSonar, AFanCountedFromStarboardComesOutFromPort) {
  auto wire = to_wire(example_image());
  std::swap(wire.bearing[0], wire.bearing[1]);
  std::swap(wire.intensity[0], wire.intensity[1]);
  const auto image = to_core(wire).value;
  ASSERT_TRUE(image);
  EXPECT_EQ(image->bearings, example_image().bearings);
  EXPECT_EQ(image->intensity, example_image().intensity);
}

TEST(ConvertSonar, BearingsThatAreNotStrictlyMonotonicAreRefused) {
  auto wire = to_wire(image_of(3, 1));
  for (const std::vector<double>& bearings : {std::vector{0.0, 0.1, 0.1}, {0.0, 0.2, 0.1}, {0.0, 0.0, 0.0}}) {
    wire.bearing = bearings;
    EXPECT_EQ(to_core(wire).refusal, "image: bearings not strictly monotonic");
  }
  wire.bearing[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(to_core(wire).refusal, "image: header not finite");
  wire.bearing.pop_back();
  EXPECT_EQ(to_core(wire).refusal, "image: beams or bins disagree with the intensities");
}

TEST(ConvertSonar, WholeStepsOfTheImagesOwnScaleStayToTheBit) {
  auto image = example_image();
  image.intensity = {0.1, 0.2, 0.3, 0.4, 0.5, 1.7};
  core::quantise(image, 255.0);  // An instrument of 8 bits.
  const auto back = to_core(to_wire(image)).value;
  EXPECT_EQ(back->intensity, image.intensity);
  EXPECT_EQ(back->intensity_scale, 1.7 / 255.0);
}

// A recording holds a mount within a turn; one and a half turns point aft.
TEST(ConvertSonar, AMountBeyondATurnPointsTheSameWay) {
  auto wire = to_wire(tests::example_scan());
  wire.mount_heading = 3.0 * std::numbers::pi;
  EXPECT_NEAR(std::abs(to_core(wire).value->T_body_sonar.heading), std::numbers::pi, 1e-12);
  wire.mount_heading = -1.25;
  EXPECT_EQ(to_core(wire).value->T_body_sonar.heading, -1.25);
  wire.mount_heading = 1e9;  // No angle: the intake refuses it.
  EXPECT_EQ(to_core(wire).value->T_body_sonar.heading, 1e9);
}

}  // namespace
}  // namespace lookout::lcmtypes
