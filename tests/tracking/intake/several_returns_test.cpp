#include "tracking/intake/several_returns.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// Ninety beams of one degree; `doubled` of ten that return give a second return.
core::SonarScan scan_of(int doubled) {
  core::SonarScan scan;
  scan.bearing_step = 0.0174;
  scan.max_range = 100.0;
  scan.num_beams = 90;
  for (int beam = 0; beam < 10; ++beam) scan.returns.push_back({beam * scan.bearing_step, 20.0});
  for (int beam = 0; beam < doubled; ++beam) scan.returns.push_back({beam * scan.bearing_step, 40.0});
  return scan;
}

TEST(SeveralReturns, AreToldOnceWithTheMeanOfTheNewestScans) {
  SeveralReturns several;
  for (int k = 0; k < 11; ++k) EXPECT_FALSE(several.learn(scan_of(10)));
  const auto mean = several.learn(scan_of(10));
  ASSERT_TRUE(mean);
  EXPECT_EQ(*mean, 20.0);
  EXPECT_FALSE(several.learn(scan_of(10)));
}

TEST(SeveralReturns, AreNoHabitWhereTheyAreFewOrSeldom) {
  SeveralReturns few, seldom;
  for (int k = 0; k < 40; ++k) {
    core::SonarScan one = scan_of(1);
    for (int i = 0; i < 100; ++i)
      one.returns.push_back({(10 + i % 70) * one.bearing_step, i < 70 ? 20.0 : 21.0});
    one.num_beams = 10;  // What lies outside of the beams is in none of them.
    EXPECT_FALSE(few.learn(one));
    EXPECT_FALSE(seldom.learn(scan_of(k % 2 == 0 ? 10 : 0)));
  }
}

}  // namespace
}  // namespace lookout::tracking
