#include "tools/experiments/harness/scan_times.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace lookout::tools {
namespace {

// 0 to 200 ms in any order: the middle one, and the one that two in 201 exceed.
TEST(ScanTimes, AreThoseOfTheMiddleAndOfOneInAHundred) {
  std::vector<double> times(201);
  std::iota(times.begin(), times.end(), 0.0);
  std::swap(times.front(), times.back());
  EXPECT_EQ(median_time(times), 100.0);
  EXPECT_EQ(high_time(times), 198.0);
  EXPECT_EQ(median_time({7.0}), 7.0);
  EXPECT_EQ(high_time({7.0}), 7.0);
}

}  // namespace
}  // namespace lookout::tools
