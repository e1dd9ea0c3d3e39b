#include "tracking/intake/sender_guard.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>

namespace lookout::tracking {
namespace {

/// How many of the numbers are another sender's.
int foreign(SenderGuard& guard, std::initializer_list<std::int64_t> numbers) {
  int count = 0;
  for (const auto number : numbers) count += guard.is_foreign(number) ? 1 : 0;
  return count;
}

TEST(SenderGuard, TheSecondOfTwoThatTakeTurnsIsForeignOnceThreeTurnsShowIt) {
  SenderGuard guard;
  EXPECT_EQ(foreign(guard, {80, 0, 81, 1, 82, 2, 83}), 0);
  EXPECT_TRUE(guard.is_foreign(3));
  EXPECT_FALSE(guard.is_foreign(84));
  EXPECT_TRUE(guard.is_foreign(4));
}

TEST(SenderGuard, OneSenderMayLoseRepeatSwapAndDamageNumbers) {
  SenderGuard guard;
  EXPECT_EQ(foreign(guard, {1, 2, 2, 4, 3, 5, 70'000, 6, 7, -5, 8, 9, 400, 10, 11, 12}), 0);
}

TEST(SenderGuard, OneSenderMayStartAgainAndJump) {
  SenderGuard guard;
  EXPECT_EQ(foreign(guard, {500, 501, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 1009, 1010, 1011}), 0);
}

// Eight in a row without one of the first: it is gone.
TEST(SenderGuard, WhoGoesOnAloneIsBelieved) {
  SenderGuard guard;
  foreign(guard, {80, 0, 81, 1, 82, 2, 83});
  EXPECT_EQ(foreign(guard, {3, 4, 5, 6, 7, 8, 9, 10, 11, 12}), 7);
}

TEST(SenderGuard, TheFarthestNumbersOverflowNothing) {
  using Limits = std::numeric_limits<std::int64_t>;
  SenderGuard guard;
  EXPECT_EQ(foreign(guard, {Limits::min(), Limits::max(), Limits::min() + 1, Limits::max()}), 0);
}

}  // namespace
}  // namespace lookout::tracking
