#include "tests/tracking/intake/intake_bench.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace lookout::tracking {
namespace {

class IntakeClockTest : public IntakeBench {};

TEST_F(IntakeClockTest, RejectsDuplicatesAndScansFromThePast) {
  surrounded_scan(10 * kSecond);
  intake_.add(scan(10 * kSecond, 0));
  intake_.add(scan(9 * kSecond, 1));
  EXPECT_EQ(counts().out_of_time, 2);
  EXPECT_EQ(out_.size(), 1u);
  surrounded_scan(11 * kSecond);
  EXPECT_EQ(out_.size(), 2u);
  EXPECT_EQ(resets_, 0);
}

TEST_F(IntakeClockTest, StartsAgainOnAClockThatJumpsAnHour) {
  std::int64_t clock = 10 * kHour;
  for (const std::int64_t jump : {std::int64_t{0}, kHour, -kHour}) {
    clock += jump;
    for (int i = 0; i < 8; ++i) surrounded_scan(clock + i * kSecond);
  }
  EXPECT_EQ(resets_, 2);
  EXPECT_EQ(counts().out_of_time, 0);
  EXPECT_EQ(out_.size(), 24u);  // Those that showed the new clock too.
}

TEST_F(IntakeClockTest, OneStampAheadIsRefusedAlone) {
  for (int i = 0; i < 40; ++i) {
    if (i % 10 == 9) {
      state(i * kSecond / 2 - kSecond / 10);
      intake_.add(scan(i * kSecond / 2 + 3 * kSecond, next_sequence_++));
      state(i * kSecond / 2 + kSecond / 10);
    } else {
      surrounded_scan(i * kSecond / 2);
    }
  }
  intake_.finish();
  EXPECT_EQ(resets_, 0);
  EXPECT_EQ(counts().accepted, 36);
  EXPECT_EQ(counts().rejected(), 4);
  EXPECT_EQ(counts().lost, 0);
}

TEST_F(IntakeClockTest, AClockThatStepsBackThreeSecondsLosesNothing) {
  for (int i = 0; i < 30; ++i) surrounded_scan(i * kSecond / 2);
  for (int i = 0; i < 30; ++i) surrounded_scan(12 * kSecond + i * kSecond / 2);
  EXPECT_EQ(resets_, 1);
  EXPECT_EQ(counts().accepted, 60);
}

// 30 s ahead the scans have no vehicle states; coming back they are where these have been all the time.
TEST_F(IntakeClockTest, ScansThatComeBackToTheClockOfTheStatesAreNoNewClock) {
  for (int i = 0; i < 60; ++i) {
    const bool is_ahead = i >= 20 && i < 40;
    state(i * kSecond / 2 - kSecond / 10);
    intake_.add(scan(i * kSecond / 2 + (is_ahead ? 30 * kSecond : 0), i));
    state(i * kSecond / 2 + kSecond / 10);
  }
  EXPECT_EQ(resets_, 0);
  EXPECT_EQ(counts().no_pose, 20);
  EXPECT_EQ(counts().accepted, 40);
  EXPECT_EQ(counts().lost, 0);
  EXPECT_TRUE(std::is_sorted(out_.begin(), out_.end(),
                             [](const auto& a, const auto& b) { return a.scan.utime < b.scan.utime; }));
}

TEST_F(IntakeClockTest, TakesStatesThatCrossAtTwentyHertz) {
  for (int i = 0; i < 100; ++i) {
    state(i * kSecond / 20 - kSecond / 20);
    intake_.add(scan(i * kSecond / 20, i));
    state(i * kSecond / 20 + kSecond / 20);
  }
  EXPECT_EQ(counts().accepted, 100);
  EXPECT_EQ(counts().bad_states, 0);
}

TEST_F(IntakeClockTest, SwappedPairsAreReorderedOnceTheStreamIsKnown) {
  for (int i = 0; i < 40; i += 2) {
    for (const int swapped : {i + 1, i}) {
      state(swapped * kSecond / 2);  // So that none waits for its pose.
      intake_.add(scan(swapped * kSecond / 2, swapped));
    }
  }
  intake_.finish();
  EXPECT_EQ(counts().accepted, 39);  // The first late one shows how late they come.
  EXPECT_EQ(counts().lost, 0);
  for (std::size_t i = 1; i < out_.size(); ++i) EXPECT_GT(out_[i].scan.utime, out_[i - 1].scan.utime);
}

TEST_F(IntakeClockTest, FindsThePoseOnANewClockThoughStatesAreFewerThanScans) {
  for (int i = 0; i < 3; ++i) surrounded_scan(kHour + i * kSecond);
  // One state a second, ten scans a second: the scans' clock is believed before the states' own would be.
  state(0);
  for (int i = 1; i <= 9; ++i) intake_.add(scan(i * kSecond / 10, i));
  state(kSecond);
  EXPECT_EQ(resets_, 1);
  EXPECT_EQ(counts().accepted, 3 + 9);
}

TEST_F(IntakeClockTest, OneStateFromTheFutureSpoilsNothing) {
  surrounded_scan(kSecond);
  state(kHour);
  for (int i = 2; i < 6; ++i) surrounded_scan(i * kSecond);
  EXPECT_EQ(counts().accepted, 5);
  EXPECT_EQ(counts().bad_states, 1);
}

TEST_F(IntakeClockTest, SaysFewLinesAboutManyBadScans) {
  surrounded_scan(kHour);
  for (int i = 0; i < 1000; ++i) intake_.add(scan(kHour, 0));
  EXPECT_EQ(counts().out_of_time, 1000);
  EXPECT_EQ(reports_.size(), 10u);  // 1, 2, 4, ... 512.
}

// A sonar that turns once in two minutes: a step of its own period is no new clock.
TEST(SlowScans, FarApartAreOfOneClockWhereTheirPeriodIsStated) {
  core::SonarParams sonar;
  sonar.scan_period = 120.0;
  int accepted = 0, resets = 0;
  ScanIntake intake(
      sonar, {[&](const core::PosedScan&) { ++accepted; }, [&] { ++resets; }, [](const std::string&) {}});
  core::SonarScan scan;
  scan.num_beams = 90;
  scan.bearing_step = core::radians(1.0);
  scan.max_range = 150.0;
  for (int i = 0; i < 10; ++i) {
    scan.utime = i * 120 * kSecond;
    scan.sequence = i;
    intake.add(core::VehicleState{scan.utime, {}, {0.0, 0.0}});
    intake.add(scan);
  }
  intake.finish();
  EXPECT_EQ(accepted, 10);
  EXPECT_EQ(resets, 0);
}

}  // namespace
}  // namespace lookout::tracking
