#include "tools/cli/images/image_feed.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

/// Notes what it was given: a letter and the time [us].
struct NotingChain {
  std::string seen;
  void add(const core::VehicleState& state) { note('s', state.utime); }
  void add(const core::SonarImage& image) { note('i', image.utime); }
  void start_new_clock() { seen += " |"; }
  void note(char kind, std::int64_t utime) { seen.append(" ").append(1, kind).append(std::to_string(utime)); }
};

void write_images(const std::string& directory,
                  const std::vector<std::pair<int, std::int64_t>>& clocks_and_times) {
  core::SonarImage image;
  image.bearings = {0.0};
  image.range_step = 1.0;
  image.num_bins = 1;
  image.intensity = {1.0};
  core::ImageWriter writer(directory);
  for (const auto& [clock, utime] : clocks_and_times) {
    image.utime = utime;
    writer.add(image, clock);
  }
  writer.close();
}

TEST(ImageFeed, TakesStatesAndImagesInOrderOfTimeAndClock) {
  const tests::TemporaryDirectory directory;
  write_images(directory.path(), {{0, 10}, {0, 30}, {1, 5}});
  core::Recording recording;
  recording.vehicle = {{0, {}, {0, 0}}, {10, {}, {0, 0}}, {40, {}, {0, 0}}, {4, {}, {0, 0}}, {6, {}, {0, 0}}};
  recording.new_clocks = {{0, 3, 0}};
  NotingChain chain;
  feed_images(chain, recording, core::ImageReader(directory.path()));
  EXPECT_EQ(chain.seen, " s0 s10 i10 i30 s40 | s4 i5 s6");
}

TEST(ImageFeed, AFixedSensorIsAtTheOriginAtEachImage) {
  const tests::TemporaryDirectory directory;
  write_images(directory.path(), {{0, 10}, {0, 30}});
  core::Recording recording;
  recording.is_fixed = true;
  NotingChain chain;
  feed_images(chain, recording, core::ImageReader(directory.path()));
  EXPECT_EQ(chain.seen, " s10 i10 s30 i30");
}

}  // namespace
}  // namespace lookout::tools
