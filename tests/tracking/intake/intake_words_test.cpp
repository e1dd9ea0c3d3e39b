#include "tracking/intake/intake_words.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

TEST(IntakeWords, SayLessTheMoreThereIsToSay) {
  int lines = 0;
  for (std::int64_t n = 1; n <= 1000; ++n) lines += worth_a_line(n) ? 1 : 0;
  EXPECT_EQ(lines, 10);  // 1, 2, 4, ..., 512.
}

TEST(IntakeWords, NamePingSensorAndTime) {
  core::SonarScan scan;
  scan.utime = 1'500'000;
  EXPECT_EQ(described(scan) + so_far(3), "scan at 1.5 s (3 so far)");
  core::SonarImage image;
  image.sensor_id = 2;
  EXPECT_EQ(described(image), "image of sensor 2 at 0 s");
}

}  // namespace
}  // namespace lookout::tracking
