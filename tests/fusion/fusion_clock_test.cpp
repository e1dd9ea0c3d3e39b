#include "fusion/fusion_clock.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
  EXPECT_NEAR(error(0, 1, 15.0), 0.0, 1e-6);     // Carried forward at its own velocity.
  EXPECT_NEAR(tracks[0].existence, 0.99, 1e-9);  // 1 - 0.1^2: the late node has its vote.
  EXPECT_EQ(fusion.count(Intake::accepted), 2 * 31 + 2 * 25);
  EXPECT_EQ(fusion.late(), 0);
  EXPECT_NEAR(fusion.clock().delay(2), 3.0, 1e-6);
  EXPECT_EQ(fusion.clock().offset(2), 0);
}

/// Target 2 is seen by the late node alone.
TEST_F(TwoNodes, ALateNodesOwnTargetIsInThePicture) {
  for (double time = 0.0; time <= 15.0; time += 0.5) {
    send(1, 1, time);
    if (time >= 3.0) {
      send(2, 1, time - 3.0);
      send(2, 2, time - 3.0);
    }
    update(time);
  }
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[1].status, core::TrackStatus::confirmed);
  EXPECT_NEAR(error(1, 2, 15.0), 0.0, 1e-6);
}

/// Honest stamps, eight seconds old: a shift of the clock would cost 8 s at 2 m/s, 16 m.
TEST_F(TwoNodes, ANodeThatIsEightSecondsLateIsNotShifted) {
  for (double time = 0.0; time <= 30.0; time += 0.5) {
    send(1, 1, time);
    if (time >= 8.0) {
      send(2, 1, time - 8.0);
      send(2, 2, time - 8.0);
    }
    update(time);
  }
  EXPECT_EQ(fusion.clock().offset(2), 0);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_NEAR(error(0, 1, 30.0), 0.0, 1e-6);
  EXPECT_NEAR(error(1, 2, 30.0), 0.0, 1e-6);
  EXPECT_NEAR(tracks[0].existence, 0.99, 1e-9);
}

/// The same stamps from a clock that is eight seconds behind: what it reports is of now.
TEST_F(TwoNodes, AClockThatIsEightSecondsBehindIsSetByWhereItsTargetsAre) {
  for (double time = 0.0; time <= 30.0; time += 0.5) {
    for (int id : {1, 2}) {
      send(1, id, time);
      if (time >= 8.0) send(2, id, time, time - 8.0, id);
    }
    update(time);
  }
  EXPECT_NEAR(core::seconds(fusion.clock().offset(2)), 8.0, 0.5);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_LT(error(0, 1, 30.0), 0.5 * 2.0);  // Half a second of its way at most.
  // Both speak for it; what the second began before its clock was set was false.
  EXPECT_NEAR(tracks[0].existence, 1.0 - 0.1 * (1.0 - fusion.global_tracks().credit_of(2)), 1e-9);
  EXPECT_GT(tracks[0].existence, 0.98);
}

TEST_F(TwoNodes, ANodeTooLateToVoteIsCounted) {
  for (double time = 0.0; time <= 40.0; time += 0.5) {
    send(1, 1, time);
    if (time >= 20.0) send(2, 1, time - 20.0);
    update(time);
  }
  EXPECT_EQ(fusion.late(), 41);  // Twenty seconds old is more than `max_age`, ten.
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_NEAR(tracks[0].existence, 0.9, 1e-9);
}

TEST_F(TwoNodes, NodesThatReportEverySixSecondsShareAPicture) {
  for (double time = 0.0; time <= 60.0; time += 6.0) {
    for (std::int32_t node : {1, 2}) {
      for (int id : {1, 2}) send(node, id, time);
    }
    update(time);
  }
  EXPECT_LE(fusion.count(Intake::clock), 2);  // The first step is believed when both have made it.
  ASSERT_EQ(tracks.size(), 2u);
  for (int id : {1, 2}) EXPECT_NEAR(std::min(error(0, id, 60.0), error(1, id, 60.0)), 0.0, 1e-6) << id;
  for (const core::Track& track : tracks) EXPECT_NEAR(track.existence, 0.99, 1e-9);
}

TEST(FusionClock, ALoneNodeThatReportsEverySixSecondsIsHeard) {
  FusionClock clock({});
  int refused = 0;
  for (int k = 0; k < 20; ++k) refused += clock.read(1, microseconds(6.0 * k)).utime ? 0 : 1;
  EXPECT_LE(refused, 2);
  EXPECT_EQ(clock.now(), microseconds(114.0));
}

TEST(FusionClock, ItsTableOfNodesIsBoundedAndTheSilentMakeRoom) {
  FusionClockParams params;
  params.max_nodes = 2;
  FusionClock clock(params);
  EXPECT_FALSE(clock.read(1, 0).is_full);
  EXPECT_FALSE(clock.read(2, 0).is_full);
  for (std::int32_t node = 3; node < 1000; ++node) EXPECT_TRUE(clock.read(node, 0).is_full);
  for (int second = 1; second <= 61; ++second) clock.read(1, microseconds(second));
  EXPECT_FALSE(clock.read(3, microseconds(61.0)).is_full);  // Node 2 has been silent for a minute.
  EXPECT_TRUE(clock.read(2, microseconds(61.0)).is_full);
}

TEST(FusionClock, TolerancesAreParameters) {
  FusionClockParams params;
  params.max_delay = 2.0 * params.tolerance;
  FusionClock clock(params);
  clock.read(1, microseconds(100.0));
  EXPECT_TRUE(clock.read(2, microseconds(91.0)).utime);
  EXPECT_FALSE(clock.read(3, microseconds(89.0)).utime);
  params.max_delay = 1.0;
  EXPECT_THROW(FusionClock{params}, std::invalid_argument);
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
  EXPECT_GT(error(0, 1, 10.5), 0.1);               // Both nodes have a say in it,
  EXPECT_NEAR(tracks[0].existence, 0.99, 1e-9);    // for both have a vote.
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
