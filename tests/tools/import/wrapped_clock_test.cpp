#include "tools/import/wrapped_clock.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

constexpr double kWrap = 4.0;  // [s]

TEST(WrappedClock, GoesOnWhereTheSonarsBeginsAgain) {
  WrappedClock clock;
  EXPECT_EQ(clock.add(7, 3.0, kWrap), 0.0);
  EXPECT_DOUBLE_EQ(clock.add(8, 3.5, kWrap), 0.5);
  EXPECT_DOUBLE_EQ(clock.add(9, 0.0, kWrap), 1.0);
}

TEST(WrappedClock, OfAGapTheCountTellsHowOftenItDid) {
  WrappedClock clock;
  clock.add(0, 0.0, kWrap);
  clock.add(1, 0.5, kWrap);
  // 20 pings of half a second are 10 s: twice around, and 2 s more.
  EXPECT_DOUBLE_EQ(clock.add(21, 2.5, kWrap), 10.5);
}

TEST(WrappedClock, ACountThatGoesBackIsARestart) {
  WrappedClock clock;
  clock.add(100, 0.0, kWrap);
  clock.add(101, 0.5, kWrap);
  EXPECT_DOUBLE_EQ(clock.add(3, 3.9, kWrap), 1.0);  // A ping later: nobody knows.
  EXPECT_EQ(clock.restarts(), 1);
  EXPECT_DOUBLE_EQ(clock.add(4, 0.4, kWrap), 1.5);
}

TEST(WrappedClock, WithoutAWrapTheStartIsTheTime) {
  WrappedClock clock;
  clock.add(0, 1000.0, 0.0);
  EXPECT_DOUBLE_EQ(clock.add(1, 1100.0, 0.0), 100.0);
  EXPECT_DOUBLE_EQ(clock.add(2, 1050.0, 0.0), 100.0);  // Never back.
}

}  // namespace
}  // namespace lookout::tools
