#include "tracking/intake/sensor_guards.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace lookout::tracking {
namespace {

constexpr double kFar = 1000.0;  // Beyond the sonar's range.

class SensorGuardsTest : public ::testing::Test {
 protected:
  SensorGuardsTest() {
    ledger_.report = [this](const std::string& line) { lines_.push_back(line); };
  }
  static core::SonarScan scan(double range) {
    const core::SonarParams sonar;
    core::SonarScan scan;
    scan.first_bearing = sonar.first_bearing;
    scan.bearing_step = sonar.bearing_step;
    scan.num_beams = sonar.num_beams;
    scan.max_range = sonar.max_range;
    for (const double bearing : {0.1, 0.2, 0.3}) scan.returns.push_back({bearing, range, 1.0});
    return scan;
  }

  core::SonarParams configured_;
  std::vector<std::string> lines_;
  IntakeLedger ledger_;
  SensorGuards guards_{configured_, ledger_};
};

TEST_F(SensorGuardsTest, CountsTheNumbersBetweenAndTellsOfThem) {
  for (const int number : {5, 6, 9}) guards_.number_comes(number);
  EXPECT_EQ(ledger_.counts.lost, 2);
  EXPECT_EQ(lines_, std::vector<std::string>{"lost before sequence 9 (2 so far)"});
}

TEST_F(SensorGuardsTest, ANumberThatIsRefusedIsNotLost) {
  guards_.number_comes(5);
  guards_.number_is_refused(6);
  guards_.number_comes(7);
  EXPECT_EQ(ledger_.counts.lost, 0);
}

// Every third ping comes a second time, twelve pings late: that is a link of two ways, and no second sender.
TEST_F(SensorGuardsTest, DoublesThatComeLateAreNoOtherSenders) {
  int foreign = 0;
  for (int i = 0; i < 100; ++i) {
    foreign += guards_.is_foreign(i, 500'000L * i) ? 1 : 0;
    if (i >= 12 && i % 3 == 0) foreign += guards_.is_foreign(i - 12, 500'000L * (i - 12)) ? 1 : 0;
  }
  EXPECT_EQ(foreign, 0);
}

TEST_F(SensorGuardsTest, ASecondSenderWithNumbersOfItsOwnIsForeign) {
  int foreign = 0;
  for (int i = 0; i < 20; ++i) {
    foreign += guards_.is_foreign(1000 + i, 500'000L * i) ? 1 : 0;
    foreign += guards_.is_foreign(i, 500'000L * i + 1000) ? 1 : 0;
  }
  EXPECT_EQ(foreign, 17);  // All but the three that show it.
}

TEST_F(SensorGuardsTest, TwoSensorsCountIntoOneLedger) {
  SensorGuards other(configured_, ledger_);
  for (SensorGuards* guards : {&guards_, &other})
    for (const int number : {1, 3}) guards->number_comes(number);
  EXPECT_EQ(ledger_.counts.lost, 2);
  EXPECT_EQ(ledger_.gaps, 2);
}

TEST_F(SensorGuardsTest, NumbersOfANewClockStartAgain) {
  guards_.number_comes(500);
  guards_.begin_new_clock();
  guards_.number_comes(0);
  EXPECT_EQ(ledger_.counts.restarts + ledger_.counts.lost, 0);
}

TEST_F(SensorGuardsTest, TheSecondRepeatIsFrozenUntilContentOrClockChange) {
  EXPECT_FALSE(guards_.is_frozen(scan(10.0)));
  EXPECT_FALSE(guards_.is_frozen(scan(10.0)));
  EXPECT_TRUE(guards_.is_frozen(scan(10.0)));
  EXPECT_FALSE(guards_.is_frozen(scan(20.0)));
  EXPECT_FALSE(guards_.is_frozen(scan(20.0)));
  guards_.begin_new_clock();
  EXPECT_FALSE(guards_.is_frozen(scan(20.0)));
  EXPECT_EQ(ledger_.counts.repeated, 3);
}

TEST_F(SensorGuardsTest, TellsOfAnotherGeometryOnceAndCountsAll) {
  core::SonarScan other = scan(10.0);
  other.max_range = 75.0;
  for (int i = 0; i < 3; ++i) guards_.look_at(other);
  guards_.look_at(scan(10.0));
  EXPECT_EQ(ledger_.counts.other_geometry, 3);
  EXPECT_EQ(lines_.size(), 1u);
}

// A sonar whose driver alternates two ranges once made a line a scan.
TEST_F(SensorGuardsTest, AGeometryThatAlwaysChangesMakesNoStreamOfLines) {
  core::SonarScan other = scan(10.0);
  for (int i = 0; i < 200; ++i) {
    other.max_range = i % 2 == 0 ? 75.0 : 90.0;
    guards_.look_at(other);
  }
  EXPECT_EQ(ledger_.counts.other_geometry, 200);
  EXPECT_EQ(lines_.size(), 8u + 4u);  // Each of the first eight, then the 16th, 32nd, 64th and 128th.
}

TEST_F(SensorGuardsTest, TellsOfStampsInMilliseconds) {
  core::SonarScan ping = scan(10.0);
  for (int i = 0; i < 20; ++i) {
    ping.utime = 500 * i;
    guards_.watch_pace(ping);
  }
  EXPECT_EQ(ledger_.counts.off_pace, 10);
  ASSERT_EQ(lines_.size(), 4u);  // 1, 2, 4 and 8 of them.
  EXPECT_EQ(lines_[0],
            "scan at 0.005 s follows the one before after 0.0005 s, faster than a sonar can ping: stamps in "
            "another unit? utime counts microseconds, time_s seconds (1 so far)");
}

TEST_F(SensorGuardsTest, TellsOfAValueOfADriversOwnForSilence) {
  for (int i = 0; i < 3; ++i) {
    core::SonarScan silent = scan(10.0);
    silent.returns.resize(12, {0.1, 65.535, 1.0});
    guards_.drop_returns_of(silent);
  }
  ASSERT_EQ(lines_.size(), 2u);  // The first and the second.
  EXPECT_NE(lines_[0].find("returns have one range, 65.535 m: does it stand for silence?"), std::string::npos)
      << lines_[0];
}

TEST_F(SensorGuardsTest, TellsOnceOfRangesInKilometres) {
  for (int i = 0; i < 40; ++i) {
    core::SonarScan near = scan(0.05);
    guards_.drop_returns_of(near);
  }
  EXPECT_EQ(lines_.size(), 1u);
}

TEST_F(SensorGuardsTest, TakesReturnsOutAndTellsOnlySuddenOnesFromASensorsHabit) {
  for (int i = 0; i < 20; ++i) {
    core::SonarScan sound = scan(10.0 + i);
    EXPECT_TRUE(guards_.contradiction(guards_.drop_returns_of(sound), 3, i).empty());
  }
  core::SonarScan far = scan(kFar);
  far.returns.resize(6, {0.1, kFar, 1.0});
  const DroppedReturns dropped = guards_.drop_returns_of(far);
  EXPECT_EQ(dropped.out_of_bounds, 6);
  EXPECT_FALSE(guards_.contradiction(dropped, 6, 20).empty());
}

}  // namespace
}  // namespace lookout::tracking
