#include "fusion/fusion_clock.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/frames.hpp"
#include "tests/fusion/two_nodes.hpp"

namespace lookout::fusion {
namespace {

using core::microseconds;
using testing::TwoNodes;

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

TEST_F(TwoNodes, ANodeIsLateByThreeSeconds) {
  for (double time = 0.0; time <= 15.0; time += 0.5) {
    for (int id : {1, 2}) {
      send(1, id, time);
      if (time >= 3.0) send(2, id, time - 3.0);  // Its honest stamps are three seconds old on arrival.
    }
    update(time);
  }
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_NEAR(error(0, 1, 15.0), 0.0, 1e-6);  // Carried forward at its own velocity.
}

TEST_F(TwoNodes, ClocksAnHourApart) {
  for (double time = 0.0; time <= 10.0; time += 0.5) {
    for (int id : {1, 2}) {
      send(1, id, time);
      send(2, id, time, time + 3600.0, id);
    }
    update(time);
  }
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_NEAR(error(0, 1, 10.0), 0.0, 1e-6);
  EXPECT_NEAR(tracks[0].existence, 0.99, 1e-9);  // Both nodes count.
  EXPECT_EQ(fusion.newest(), microseconds(10.0));
}

TEST_F(TwoNodes, ClocksHalfASecondApartCostHalfASecondOfWay) {
  for (double time = 0.0; time <= 10.0; time += 0.5) {
    for (int id : {1, 2}) {
      send(1, id, time);
      send(2, id, time, time + 0.5, id);
    }
    update(time + 0.5);
  }
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_LT(error(0, 1, 10.5), 0.5 * 2.0 + 1e-6);  // Speed times the difference of the clocks.
}

TEST_F(TwoNodes, ARestartOfEverythingBeginsANewPicture) {
  run(100.0, 105.0);
  run(0.0, 1.5);  // Refused until the new clock has been heard three times.
  EXPECT_EQ(fusion.restarts(), 1);
  run(2.0, 6.0);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_GE(tracks[0].id, 3);
  EXPECT_NEAR(error(0, 1, 6.0), 0.0, 1e-6);
}

}  // namespace
}  // namespace lookout::fusion
