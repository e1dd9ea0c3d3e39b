#include "tracking/intake/clock_guard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace lookout::tracking {
namespace {

using Verdict = ClockGuard::Verdict;

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kHour = 3600 * kSecond;

TEST(ClockGuard, BelievesTimesThatGoOn) {
  ClockGuard guard;
  EXPECT_EQ(guard.judge(0), Verdict::in_order);
  EXPECT_EQ(guard.judge(1), Verdict::in_order);
  EXPECT_EQ(guard.judge(kSecond), Verdict::in_order);
  EXPECT_EQ(guard.judge(4 * kSecond - 3), Verdict::in_order);  // Three times the step before.
}

TEST(ClockGuard, TellsLateFromSuspect) {
  ClockGuard guard;
  guard.judge(10 * kSecond);
  EXPECT_EQ(guard.judge(10 * kSecond), Verdict::late);
  EXPECT_EQ(guard.judge(9 * kSecond), Verdict::late);
  EXPECT_EQ(guard.judge(9 * kSecond - 1), Verdict::suspect);
  EXPECT_EQ(guard.judge(10 * kSecond + kHour), Verdict::suspect);
  EXPECT_EQ(guard.last(), 10 * kSecond);
}

TEST(ClockGuard, ALeapIsAPauseWhereTheNextAgreesAndElseOneBadStamp) {
  ClockGuard guard;
  for (const int tenths : {0, 5, 10}) guard.judge(tenths * kSecond / 10);
  EXPECT_EQ(guard.judge(4 * kSecond), Verdict::suspect);
  EXPECT_EQ(guard.judge(3 * kSecond / 2), Verdict::in_order);  // It was bad.
  EXPECT_EQ(guard.judge(5 * kSecond), Verdict::suspect);
  EXPECT_EQ(guard.judge(11 * kSecond / 2), Verdict::resumed);
  EXPECT_EQ(guard.judge(6 * kSecond), Verdict::in_order);
}

TEST(ClockGuard, BelievesAPauseAtOnceThatIsExpected) {
  ClockGuard guard;
  for (const int tenths : {0, 5, 10}) guard.judge(tenths * kSecond / 10);
  guard.expect_pause();
  EXPECT_EQ(guard.judge(4 * kSecond), Verdict::in_order);
  EXPECT_EQ(guard.judge(7 * kSecond), Verdict::suspect);  // The next is none, and no pace was learnt of it.
  ClockGuard other;
  other.judge(kHour);
  other.expect_pause();
  EXPECT_EQ(other.judge(2 * kHour), Verdict::suspect);  // Too far for a pause.
}

TEST(ClockGuard, FollowsASlowSensor) {
  ClockGuard guard;
  guard.judge(0);
  EXPECT_EQ(guard.judge(20 * kSecond), Verdict::suspect);
  EXPECT_EQ(guard.judge(40 * kSecond), Verdict::resumed);
  for (int i = 3; i < 6; ++i) EXPECT_EQ(guard.judge(i * (20 * kSecond)), Verdict::in_order);
}

// A turn takes it 100 s, longer than the longest step of one clock that was told.
TEST(ClockGuard, FindsAPaceBelowTheLongestStepFromTwoStepsThatAreAlike) {
  ClockGuard guard;
  EXPECT_EQ(guard.judge(0), Verdict::in_order);
  EXPECT_EQ(guard.judge(100 * kSecond), Verdict::suspect);
  EXPECT_EQ(guard.judge(198 * kSecond), Verdict::resumed);
  for (const std::int64_t second : {300, 399, 500, 700})
    EXPECT_EQ(guard.judge(second * kSecond), Verdict::in_order);
}

TEST(ClockGuard, FindsAPaceOfWhichTwoStepsAreLongerThanTheLongest) {
  for (const std::int64_t pace : {40, 60}) {
    ClockGuard guard;
    EXPECT_EQ(guard.judge(0), Verdict::in_order);
    EXPECT_EQ(guard.judge(pace * kSecond), Verdict::suspect);
    EXPECT_EQ(guard.judge(2 * pace * kSecond), Verdict::resumed) << pace;
    EXPECT_EQ(guard.judge(3 * pace * kSecond + kSecond), Verdict::in_order) << pace;
  }
}

TEST(ClockGuard, TakesNoTwoLeapsThatDifferForAPace) {
  ClockGuard guard;
  for (const std::int64_t second : {0, 1, 2}) guard.judge(second * kSecond);
  EXPECT_EQ(guard.judge(102 * kSecond), Verdict::suspect);
  EXPECT_EQ(guard.judge(2 * kHour), Verdict::suspect);
  EXPECT_EQ(guard.judge(3 * kSecond), Verdict::in_order);
}

TEST(ClockGuard, AtTheEndBelievesWhatLiesAhead) {
  ClockGuard guard;
  guard.judge(10 * kSecond);
  guard.judge(kSecond);
  EXPECT_FALSE(guard.adopt_suspects_ahead());
  guard.judge(15 * kSecond);
  EXPECT_TRUE(guard.adopt_suspects_ahead());
  EXPECT_EQ(guard.last(), 15 * kSecond);
}

TEST(ClockGuard, BelievesANewClockAfterFiveConsistentTimes) {
  for (const std::int64_t jump : {-kHour, kHour}) {
    ClockGuard guard;
    guard.judge(2 * kHour);
    for (int i = 1; i < 5; ++i) EXPECT_EQ(guard.judge(2 * kHour + jump + i * kSecond), Verdict::suspect);
    EXPECT_EQ(guard.judge(2 * kHour + jump + 5 * kSecond), Verdict::new_clock);
    EXPECT_EQ(guard.judge(2 * kHour + jump + 6 * kSecond), Verdict::in_order);
  }
}

TEST(ClockGuard, BelievesAClockThatWasSetBackThoughItReachesTheOldOne) {
  ClockGuard guard;
  for (int half = 0; half < 30; ++half) guard.judge(half * kSecond / 2);
  for (int half = 24; half < 28; ++half) EXPECT_EQ(guard.judge(half * kSecond / 2), Verdict::suspect) << half;
  EXPECT_EQ(guard.judge(14 * kSecond), Verdict::new_clock);
  EXPECT_EQ(guard.judge(29 * kSecond / 2), Verdict::in_order);
}

TEST(ClockGuard, StrayTimesAmongGoodOnesNeverMakeAClock) {
  ClockGuard guard;
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(guard.judge(kHour + i * kSecond), Verdict::in_order);
    EXPECT_EQ(guard.judge(i * kSecond), Verdict::suspect);
  }
}

TEST(ClockGuard, SuspectsThatDoNotFollowOneAnotherNeverMakeAClock) {
  ClockGuard guard;
  guard.judge(100 * kHour);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(guard.judge((50 - i) * kHour), Verdict::suspect);
}

// A sonar that pings four times every two minutes was heard in its first four, and never again.
TEST(ClockGuard, BelievesAStreamWhosePausesAreLongAndWhoseTimesBetweenAreFew) {
  for (const int burst : {2, 3, 4}) {
    ClockGuard guard;
    int suspects = 0, longest = 0;
    for (int k = 0; k < 20 * burst; ++k) {
      const std::int64_t utime = (k / burst * 120 + k % burst) * kSecond;
      suspects = guard.judge(utime) == Verdict::suspect ? suspects + 1 : 0;
      longest = std::max(longest, suspects);
    }
    EXPECT_LT(longest, ClockGuardParams().new_clock_after) << burst;
  }
}

TEST(ClockGuard, SingleLeapsFartherAndFartherAheadMakeNoClock) {
  ClockGuard guard;
  guard.judge(0);
  for (std::int64_t time = 100 * kSecond; time < 1000 * kHour; time *= 3)
    EXPECT_EQ(guard.judge(time), Verdict::suspect);
}

TEST(ClockGuard, AdoptsSuspectsOnlyNearTheGivenTime) {
  ClockGuard guard;
  guard.judge(2 * kHour);
  EXPECT_FALSE(guard.adopt_suspects_near(0));
  guard.judge(kSecond);
  EXPECT_FALSE(guard.adopt_suspects_near(kHour));
  EXPECT_TRUE(guard.adopt_suspects_near(2 * kSecond));
  EXPECT_EQ(guard.judge(3 * kSecond / 2), Verdict::in_order);
}

TEST(ClockGuard, RefusesParamsOutOfRange) {
  EXPECT_THROW(ClockGuard({0, 5}), std::invalid_argument);
  EXPECT_THROW(ClockGuard({1, 0}), std::invalid_argument);
  EXPECT_THROW(ClockGuard({1, 1, -1}), std::invalid_argument);
  EXPECT_THROW(ClockGuard({1, 1, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
