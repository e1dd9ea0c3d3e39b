#include "tracking/intake/outside_returns.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

/// Of `seconds` scans, a second apart, with `outside` of 30 returns outside: how many contradict.
int contradictions(OutsideReturns& habit, int outside, int seconds, std::int64_t begin) {
  int count = 0;
  for (int i = 0; i < seconds; ++i) count += habit.contradict(outside, 30, begin + i * kSecond) ? 1 : 0;
  return count;
}

TEST(OutsideReturns, MostOutsideAllOfASuddenContradict) {
  OutsideReturns habit;
  EXPECT_EQ(contradictions(habit, 1, 20, 0), 0);
  EXPECT_EQ(contradictions(habit, 27, 15, 20 * kSecond), 15);
  EXPECT_EQ(contradictions(habit, 1, 20, 35 * kSecond), 0);
}

TEST(OutsideReturns, ADriverThatSaysSilenceByThemKeepsItsWay) {
  OutsideReturns habit;
  EXPECT_EQ(contradictions(habit, 27, 60, 0), 0);
  EXPECT_EQ(contradictions(habit, 29, 60, 60 * kSecond), 0);
}

TEST(OutsideReturns, AfterTwentySecondsTheyAreTheNewHabit) {
  OutsideReturns habit;
  contradictions(habit, 0, 20, 0);
  EXPECT_EQ(contradictions(habit, 27, 60, 20 * kSecond), 21);  // The first and those up to 20 s behind it.
}

TEST(OutsideReturns, AFewReturnsSayNothing) {
  OutsideReturns habit;
  contradictions(habit, 0, 20, 0);
  EXPECT_FALSE(habit.contradict(4, 4, 20 * kSecond));
  EXPECT_FALSE(habit.contradict(0, 0, 21 * kSecond));
}

}  // namespace
}  // namespace lookout::tracking
