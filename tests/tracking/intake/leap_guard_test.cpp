#include "tracking/intake/leap_guard.hpp"

#include <gtest/gtest.h>

#include "core/frames.hpp"

namespace lookout::tracking {
namespace {

constexpr double kStep = 0.25;  // s between two values

/// How many of the values of [from, to) [s] are doubted that are all so far off.
int doubted(LeapGuard& guard, double from, double to, double off) {
  int count = 0;
  for (double second = from; second < to; second += kStep)
    count += guard.is_leap(core::microseconds(second), off) ? 1 : 0;
  return count;
}

LeapGuard guard() {
  return LeapGuard({.leap = 20.0, .rate = 10.0});
}

TEST(LeapGuard, DoubtsALeapUntilItIsBack) {
  LeapGuard one = guard();
  EXPECT_EQ(doubted(one, 0.0, 40.0, 0.0), 0);
  EXPECT_EQ(doubted(one, 40.0, 50.0, 300.0), 40);
  EXPECT_EQ(doubted(one, 50.0, 52.0, 160.0), 8);  // Not within half of the leap.
  EXPECT_FALSE(one.is_leap(core::microseconds(52.0), 140.0));
}

TEST(LeapGuard, BelievesALeapThatLastsAndThenRests) {
  LeapGuard one = guard();
  doubted(one, 0.0, 40.0, 0.0);
  EXPECT_EQ(doubted(one, 40.0, 60.25, 300.0), 81);  // 20 s, with the value at their end.
  EXPECT_FALSE(one.is_leap(core::microseconds(60.25), 300.0));
  EXPECT_EQ(doubted(one, 60.5, 110.0, 300.0), 0);  // For a minute whatever comes.
  EXPECT_EQ(doubted(one, 110.0, 125.0, 0.0), 0);
  EXPECT_EQ(doubted(one, 125.0, 130.0, 300.0), 20);
}

TEST(LeapGuard, DoubtsNoLongerThanTheLineBeforeLasted) {
  LeapGuard one = guard();
  EXPECT_EQ(doubted(one, 0.0, 1.0, 0.0), 0);
  EXPECT_EQ(doubted(one, 1.0, 60.0, 300.0), 5);  // 1 s.
}

TEST(LeapGuard, AStepThatMayBeIsNone) {
  LeapGuard one = guard();
  doubted(one, 0.0, 10.0, 0.0);
  EXPECT_FALSE(one.is_leap(core::microseconds(10.0), 22.0));  // 20 and 10 a second
  EXPECT_TRUE(one.is_leap(core::microseconds(10.25), 23.0));
  EXPECT_FALSE(one.is_leap(core::microseconds(10.5), 0.0));
  EXPECT_FALSE(one.is_leap(core::microseconds(13.0), 400.0));  // 2.5 s of silence
}

}  // namespace
}  // namespace lookout::tracking
