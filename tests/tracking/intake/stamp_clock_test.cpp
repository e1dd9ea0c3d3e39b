#include "tracking/intake/stamp_clock.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// Sixty pings, `period` seconds apart, stamped in units of 1 / `per_second` seconds.
std::optional<std::int64_t> slower(double period, double per_second, StampClock clock = {}) {
  for (int i = 0; i < 60; ++i)
    clock.add(static_cast<std::int64_t>(i * period * per_second),
              static_cast<std::int64_t>(i * period * 1e6));
  return clock.slower();
}

TEST(StampClock, KnowsMillisecondsAndSecondsAtAnyPace) {
  for (const double period : {0.5, 2.0, 10.0, 60.0}) {
    EXPECT_EQ(slower(period, 1e3), 1'000) << period;
    EXPECT_EQ(slower(period, 1e6), std::nullopt) << period;
  }
  EXPECT_EQ(slower(10.0, 1.0), 1'000'000);
}

TEST(StampClock, LeavesSimulationsAndReplaysOfAnySpeedAlone) {
  for (const double speed : {0.1, 10.0, 100.0, 1000.0})
    EXPECT_EQ(slower(0.5, 1e6 * speed), std::nullopt) << speed;
}

TEST(StampClock, CountsWhatCameWhileItDoubts) {
  StampClock clock;
  for (int i = 0; i < 20; ++i) clock.add(10'000 * i, 10'000'000L * i);
  EXPECT_EQ(clock.doubted(), 10);  // From the tenth step of the nineteen on.
}

TEST(StampClock, IsNotMisledByAClockThatIsSetBack) {
  StampClock clock;
  for (int i = 0; i < 60; ++i) clock.add(500'000L * (i % 20), 500'000L * i);
  EXPECT_FALSE(clock.slower());
}

}  // namespace
}  // namespace lookout::tracking
