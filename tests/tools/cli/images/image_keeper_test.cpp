#include "tools/cli/images/image_keeper.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

core::SonarImage image_at(std::int64_t utime, std::int32_t sensor = 0) {
  core::SonarImage image;
  image.utime = utime;
  image.sensor_id = sensor;
  image.bearings = {0.0};
  image.range_step = 1.0;
  image.num_bins = 1;
  image.intensity = {1.0};
  return image;
}

TEST(ImageKeeper, KeepsOneClockAndCountsTheRest) {
  const tests::TemporaryDirectory directory;
  ImageKeeper keeper(directory.path());
  for (const auto& image : {image_at(1), image_at(1, 7), image_at(2), image_at(2), image_at(0)})
    keeper.add(image);
  EXPECT_TRUE(keeper.close());
  EXPECT_EQ(keeper.left_out(), 2);  // A time of sensor 0 again, and one that goes back.
  EXPECT_EQ(core::ImageReader(directory.path()).size(), 3u);
}

TEST(ImageKeeper, WithoutAnImageThereIsNoRecording) {
  const tests::TemporaryDirectory directory;
  ImageKeeper keeper(directory.path());
  EXPECT_FALSE(keeper.close());
  EXPECT_FALSE(core::holds_images(directory.path()));
}

}  // namespace
}  // namespace lookout::tools
