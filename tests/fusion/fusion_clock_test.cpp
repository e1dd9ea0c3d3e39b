#include "fusion/fusion_clock.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/frames.hpp"

namespace lookout::fusion {
namespace {

using core::microseconds;

constexpr double kHour = 3600.0;

TEST(FusionClock, LateAndEarlyStampsAreTrusted) {
  FusionClock clock({});
  EXPECT_EQ(clock.read(1, microseconds(100.0)).utime, microseconds(100.0));
  EXPECT_EQ(clock.read(2, microseconds(96.0)).utime, microseconds(96.0));
  EXPECT_EQ(clock.read(1, microseconds(104.0)).utime, microseconds(104.0));
  EXPECT_EQ(clock.now(), microseconds(104.0));
}

TEST(FusionClock, ASingleWildStampIsRefused) {
  FusionClock clock({});
  clock.read(1, microseconds(100.0));
  EXPECT_FALSE(clock.read(2, std::numeric_limits<std::int64_t>::max()).utime);
  EXPECT_FALSE(clock.read(2, std::numeric_limits<std::int64_t>::min()).utime);
  EXPECT_EQ(clock.now(), microseconds(100.0));
  EXPECT_TRUE(clock.read(2, microseconds(100.5)).utime);
}

TEST(FusionClock, AnotherClockIsShiftedWhileOthersAreHeard) {
  FusionClock clock({});
  for (int k = 0; k < 3; ++k) {
    clock.read(1, microseconds(100.0 + k));
    clock.read(2, microseconds(kHour + k));
  }
  EXPECT_EQ(clock.offset(2), microseconds(100.0 - kHour));
  clock.read(1, microseconds(103.0));
  EXPECT_EQ(clock.read(2, microseconds(kHour + 3.0)).utime, microseconds(103.0 + 0.0));
  EXPECT_EQ(clock.now(), microseconds(103.0));
}

TEST(FusionClock, APauseOfAllPassesTime) {
  FusionClock clock({});
  clock.read(1, microseconds(0.0));
  EXPECT_FALSE(clock.read(1, microseconds(60.0)).utime);
  EXPECT_FALSE(clock.read(1, microseconds(60.5)).utime);
  EXPECT_EQ(clock.read(1, microseconds(61.0)).utime, microseconds(61.0));
  EXPECT_EQ(clock.offset(1), 0);
}

TEST(FusionClock, ARestartOfAllBeginsAnew) {
  FusionClock clock({});
  clock.read(1, microseconds(kHour));
  clock.read(1, microseconds(0.0));
  clock.read(1, microseconds(0.5));
  const auto reading = clock.read(1, microseconds(1.0));
  EXPECT_TRUE(reading.restarted);
  EXPECT_EQ(reading.utime, microseconds(1.0));
  EXPECT_EQ(clock.now(), microseconds(1.0));
}

}  // namespace
}  // namespace lookout::fusion
