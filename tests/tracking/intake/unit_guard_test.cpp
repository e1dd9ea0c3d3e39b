#include "tracking/intake/unit_guard.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

using Pace = UnitGuard::Pace;

/// Of `pings` that follow each other after `step` microseconds, how many have this pace.
int count(UnitGuard& guard, Pace pace, int pings, std::int64_t step) {
  int count = 0;
  for (int i = 0; i < pings; ++i) count += guard.judge_pace(i * step) == pace ? 1 : 0;
  return count;
}

// The tenth step ends at the eleventh ping.
TEST(UnitGuard, HalfASecondInMillisecondsIsTooFast) {
  UnitGuard guard(0.5);
  EXPECT_EQ(count(guard, Pace::too_fast, 30, 500), 20);
  EXPECT_EQ(guard.step(), 500);
}

TEST(UnitGuard, SixSecondsInMillisecondsAreTooFastWhereThePeriodIsStated) {
  UnitGuard guard(6.0);
  EXPECT_EQ(count(guard, Pace::too_fast, 30, 6'000), 20);
}

// Told at the tenth to the nineteenth step; then it is the sensor's own pace, as that of a scan a minute is.
TEST(UnitGuard, HalfASecondInNanosecondsIsTooSlow) {
  UnitGuard guard(0.5);
  EXPECT_EQ(count(guard, Pace::too_slow, 100, 500'000'000), 10);
}

TEST(UnitGuard, FastAndSlowSonarsArePlausible) {
  for (const std::int64_t step : {10'000, 50'000, 500'000, 20'000'000}) {  // 100 Hz to a turn in 20 s.
    UnitGuard guard(0.5);
    EXPECT_EQ(count(guard, Pace::plausible, 100, step), 100) << step;
  }
}

TEST(UnitGuard, BurstsDoublesAndStepsBackArePlausible) {
  UnitGuard guard(0.5);
  for (int burst = 0; burst < 20; ++burst)
    for (const std::int64_t offset : {0, 100, 100, 200, 200, 50})
      EXPECT_EQ(guard.judge_pace(burst * 500'000L + offset), Pace::plausible);
}

TEST(UnitGuard, ANewClockBeginsAnew) {
  UnitGuard guard(0.5);
  count(guard, Pace::too_fast, 30, 500);
  guard.begin_new_clock();
  EXPECT_EQ(count(guard, Pace::too_fast, 10, 500), 0);
}

/// What is said of `UnitGuard::kLooked` pings with these ranges, and of one more.
std::string doubt(const UnitGuard::Ranges& ranges) {
  UnitGuard guard(0.5);
  std::string said;
  for (int ping = 0; ping <= UnitGuard::kLooked; ++ping) {
    said += guard.doubt_ranges({});  // One without returns says nothing.
    said += guard.doubt_ranges(ranges);
  }
  return said;
}

TEST(UnitGuard, RangesThatAreAllOutsideAreTold) {
  EXPECT_EQ(
      doubt({3, 3, 0.0, 100.0}),
      "all 60 returns so far lie outside of its beams or range: degrees, millimetres, another geometry?");
}

TEST(UnitGuard, RangesThatAreAllAtTheSonarAreTold) {
  EXPECT_EQ(doubt({3, 0, 0.09, 100.0}),
            "all 60 returns so far lie within 0.09 m of a range of 100 m: kilometres?");
}

// Whoever says silence by a range beyond the maximum has nearly all outside.
TEST(UnitGuard, RangesOfASonarAreNotDoubted) {
  EXPECT_EQ(doubt({60, 57, 80.0, 100.0}), "");
  EXPECT_EQ(doubt({1, 0, 1.5, 100.0}), "");
}

}  // namespace
}  // namespace lookout::tracking
