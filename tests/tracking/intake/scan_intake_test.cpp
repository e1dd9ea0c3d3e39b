#include "tracking/intake/scan_intake.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kHour = 3600 * kSecond;

/// An intake whose output is kept. The vehicle goes north at 1 m/s, so that a pose shows its time.
class ScanIntakeTest : public ::testing::Test {
 protected:
  static core::SonarScan scan(std::int64_t utime, std::int64_t sequence) {
    core::SonarScan scan;
    scan.utime = utime;
    scan.sequence = sequence;
    scan.first_bearing = core::SonarParams().first_bearing;
    scan.bearing_step = core::SonarParams().bearing_step;
    scan.max_range = 150.0;
    scan.num_beams = 90;
    return scan;
  }
  void state(std::int64_t utime) {
    intake_.add(core::VehicleState{utime, {core::seconds(utime), 0.0, 0.0}, {1.0, 0.0}});
  }
  /// A scan between two states, 0.1 s before and after it.
  void surrounded_scan(std::int64_t utime) {
    state(utime - kSecond / 10);
    intake_.add(scan(utime, next_sequence_++));
    state(utime + kSecond / 10);
  }
  const IntakeCounts& counts() const { return intake_.counts(); }

  std::vector<core::PosedScan> out_;
  int resets_ = 0;
  std::vector<std::string> reports_;
  std::int64_t next_sequence_ = 0;
  ScanIntake intake_{core::SonarParams(),
                     {[this](const core::PosedScan& posed) { out_.push_back(posed); }, [this] { ++resets_; },
                      [this](const std::string& line) { reports_.push_back(line); }}};
};

TEST_F(ScanIntakeTest, InterpolatesThePoseAtTheTimeOfTheScan) {
  state(0);
  intake_.add(scan(kSecond / 4, 0));
  EXPECT_TRUE(out_.empty());  // It waits for the state after it.
  state(kSecond);
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_NEAR(out_[0].T_earth_sonar.north, 0.25, 1e-9);
  EXPECT_EQ(counts().accepted, 1);
}

TEST_F(ScanIntakeTest, AStateAtExactlyTheTimeOfTheScanServesAsBoth) {
  state(kSecond);
  intake_.add(scan(kSecond, 0));
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_EQ(out_[0].T_earth_sonar.north, 1.0);
}

TEST_F(ScanIntakeTest, HandsScansOutInOrderAsTheirPosesCome) {
  state(0);
  for (int i = 1; i <= 3; ++i) intake_.add(scan(i * kSecond / 4, i));
  state(kSecond);
  ASSERT_EQ(out_.size(), 3u);
  for (int i = 1; i <= 3; ++i) EXPECT_EQ(out_[static_cast<std::size_t>(i - 1)].scan.sequence, i);
}

TEST_F(ScanIntakeTest, RejectsAScanBeforeAnyVehicleState) {
  intake_.add(scan(0, 0));
  state(kSecond / 2);
  EXPECT_EQ(counts().no_pose, 1);
  EXPECT_EQ(counts().accepted, 0);
  ASSERT_EQ(reports_.size(), 1u);
  EXPECT_EQ(reports_[0], "scan at 0 s rejected: no pose: it is older than the vehicle states (1 so far)");
}

TEST_F(ScanIntakeTest, RejectsAScanThatWaitedOverASecondOfDataTime) {
  state(0);
  intake_.add(scan(kSecond / 10, 0));
  intake_.add(scan(kSecond + kSecond / 10, 1));
  EXPECT_EQ(counts().no_pose, 0);  // Exactly one second.
  intake_.add(scan(kSecond + kSecond / 10 + 1, 2));
  EXPECT_EQ(counts().no_pose, 1);
}

TEST_F(ScanIntakeTest, RejectsAScanInAGapOfOverTwoSeconds) {
  state(0);
  intake_.add(scan(kSecond / 2, 0));
  state(2 * kSecond + 1);
  intake_.finish();
  EXPECT_EQ(counts().no_pose, 1);
  ASSERT_EQ(reports_.size(), 1u);
  EXPECT_EQ(reports_[0],
            "scan at 0.5 s rejected: no pose: the vehicle states around it are 2.000001 s apart, above "
            "max_pose_gap_s (2 s; set it in `sensor:` of the configuration) (1 so far)");
}

TEST_F(ScanIntakeTest, WaitsForStatesAsFarApartAsItIsTold) {
  core::SonarParams sensor;
  sensor.max_pose_gap = 20.0;
  std::vector<double> north;
  ScanIntake intake(sensor,
                    {[&](const core::PosedScan& posed) { north.push_back(posed.T_earth_sonar.north); }, [] {},
                     [](const std::string&) {}});
  for (int second = 0; second < 40; ++second) {
    if (second % 20 == 0)
      intake.add(core::VehicleState{second * kSecond, {1.0 * second, 0.0, 0.0}, {1.0, 0.0}});
    intake.add(scan(second * kSecond, second));
  }
  intake.add(core::VehicleState{40 * kSecond, {40.0, 0.0, 0.0}, {1.0, 0.0}});
  ASSERT_EQ(north.size(), 40u);
  for (int second = 0; second < 40; ++second)
    EXPECT_NEAR(north[static_cast<std::size_t>(second)], second, 1e-9);
}

TEST_F(ScanIntakeTest, RejectsDuplicatesAndScansFromThePast) {
  surrounded_scan(10 * kSecond);
  intake_.add(scan(10 * kSecond, 0));
  intake_.add(scan(9 * kSecond, 1));
  EXPECT_EQ(counts().out_of_time, 2);
  EXPECT_EQ(out_.size(), 1u);
  surrounded_scan(11 * kSecond);
  EXPECT_EQ(out_.size(), 2u);
  EXPECT_EQ(resets_, 0);
}

TEST_F(ScanIntakeTest, StartsAgainOnAClockThatJumpsAnHour) {
  std::int64_t clock = 10 * kHour;
  for (const std::int64_t jump : {std::int64_t{0}, kHour, -kHour}) {
    clock += jump;
    for (int i = 0; i < 8; ++i) surrounded_scan(clock + i * kSecond);
  }
  EXPECT_EQ(resets_, 2);
  EXPECT_EQ(counts().out_of_time, 0);
  EXPECT_EQ(out_.size(), 24u);  // Those that showed the new clock too.
}

TEST_F(ScanIntakeTest, OneStampAheadIsRefusedAlone) {
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

TEST_F(ScanIntakeTest, AClockThatStepsBackThreeSecondsLosesNothing) {
  for (int i = 0; i < 30; ++i) surrounded_scan(i * kSecond / 2);
  for (int i = 0; i < 30; ++i) surrounded_scan(12 * kSecond + i * kSecond / 2);
  EXPECT_EQ(resets_, 1);
  EXPECT_EQ(counts().accepted, 60);
}

// 30 s ahead the scans have no vehicle states; coming back they are where these have been all the time.
TEST_F(ScanIntakeTest, ScansThatComeBackToTheClockOfTheStatesAreNoNewClock) {
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

TEST_F(ScanIntakeTest, LeavesOutAScanWhoseReturnsSuddenlyLieOutside) {
  for (int i = 0; i < 20; ++i) {
    auto ping = scan(i * kSecond, i);
    for (int k = 0; k < 6; ++k)
      ping.returns.push_back({0.1 * k, (i == 15 ? 100.0 : 10.0) * (k + 2) + i, 1.0});
    state(ping.utime);
    intake_.add(ping);
  }
  EXPECT_EQ(counts().contradicting, 1);
  EXPECT_EQ(counts().accepted, 19);
  EXPECT_EQ(counts().returns, 19 * 6);
}

TEST_F(ScanIntakeTest, TakesStatesThatCrossAtTwentyHertz) {
  for (int i = 0; i < 100; ++i) {
    state(i * kSecond / 20 - kSecond / 20);
    intake_.add(scan(i * kSecond / 20, i));
    state(i * kSecond / 20 + kSecond / 20);
  }
  EXPECT_EQ(counts().accepted, 100);
  EXPECT_EQ(counts().bad_states, 0);
}

TEST_F(ScanIntakeTest, SwappedPairsAreReorderedOnceTheStreamIsKnown) {
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

TEST_F(ScanIntakeTest, TwoSensorsShareATimeAndHaveTheirOwnSequences) {
  for (int i = 0; i < 10; ++i) {
    state(i * kSecond);
    for (const int sensor : {1, 2}) {
      auto ping = scan(i * kSecond, i + 1000 * (sensor - 1));
      ping.sensor_id = sensor;
      ping.T_body_sonar.heading = sensor - 1.0;
      intake_.add(ping);
    }
  }
  EXPECT_EQ(counts().accepted, 20);
  EXPECT_EQ(counts().rejected() + counts().lost + counts().restarts, 0);
  EXPECT_EQ(reports_.size(), 1u);  // The geometry of the second, once.
}

// Two senders: nothing is lost, but the numbers go to and fro. Of the second three are taken, two are not.
TEST_F(ScanIntakeTest, CountsNumbersThatGoToAndFroAndLeavesTheSecondSenderOut) {
  for (int i = 0; i < 10; ++i) {
    next_sequence_ = i % 2 == 0 ? 1000 + i / 2 : i / 2;
    surrounded_scan(i * kSecond);
  }
  EXPECT_EQ(counts().lost, 0);
  EXPECT_EQ(counts().backwards, 3);
  EXPECT_EQ(counts().foreign, 2);
  EXPECT_EQ(counts().accepted, 8);
}

TEST_F(ScanIntakeTest, CountsHeadingsThatNoRadianHas) {
  intake_.add(core::VehicleState{0, {0.0, 0.0, 6.0}, {0.0, 0.0}});
  intake_.add(core::VehicleState{kSecond, {0.0, 0.0, 30.0}, {0.0, 0.0}});
  EXPECT_EQ(counts().wide_headings, 1);
  EXPECT_EQ(counts().accepted_states, 2);
}

// The first repeat may be chance; from the second on nothing is learnt of them.
TEST_F(ScanIntakeTest, TellsOfASensorThatIsFrozenAndLeavesItOut) {
  auto ping = scan(0, 0);
  ping.returns = {{0.0, 10.0, 1.0}, {0.1, 20.0, 1.0}, {0.2, 30.0, 1.0}};
  for (int i = 0; i < 5; ++i) {
    ping.utime = i * kSecond;
    ping.sequence = i;
    state(ping.utime);
    intake_.add(ping);
  }
  EXPECT_EQ(counts().accepted, 2);
  EXPECT_EQ(counts().frozen, 3);
  EXPECT_EQ(counts().rejected(), 3);
  EXPECT_EQ(counts().repeated, 4);
  EXPECT_EQ(reports_.size(), 5u);  // Repeats 1, 2 and 4, rejections 1 and 2.
}

TEST_F(ScanIntakeTest, CountsEveryScanOnce) {
  surrounded_scan(kSecond);
  intake_.add(scan(kSecond, 0));
  auto damaged = scan(2 * kSecond, 1);
  damaged.num_beams = 0;
  intake_.add(damaged);
  intake_.add(scan(500 * kSecond, 2));
  surrounded_scan(3 * kSecond / 2);
  intake_.add(scan(2 * kSecond, 4));
  intake_.finish();
  EXPECT_EQ(counts().received, 6);
  EXPECT_EQ(counts().accepted + counts().rejected(), 6);
}

TEST_F(ScanIntakeTest, FindsThePoseOnANewClockThoughStatesAreFewerThanScans) {
  for (int i = 0; i < 3; ++i) surrounded_scan(kHour + i * kSecond);
  // One state a second, ten scans a second: the scans' clock is believed before the states' own would be.
  state(0);
  for (int i = 1; i <= 9; ++i) intake_.add(scan(i * kSecond / 10, i));
  state(kSecond);
  EXPECT_EQ(resets_, 1);
  EXPECT_EQ(counts().accepted, 3 + 9);
}

TEST_F(ScanIntakeTest, OneStateFromTheFutureSpoilsNothing) {
  surrounded_scan(kSecond);
  state(kHour);
  for (int i = 2; i < 6; ++i) surrounded_scan(i * kSecond);
  EXPECT_EQ(counts().accepted, 5);
  EXPECT_EQ(counts().bad_states, 1);
}

TEST_F(ScanIntakeTest, CountsLossAndRestartBySequence) {
  surrounded_scan(kSecond);
  next_sequence_ = 4;
  surrounded_scan(2 * kSecond);
  EXPECT_EQ(counts().lost, 3);
  next_sequence_ = 0;
  surrounded_scan(3 * kSecond);
  EXPECT_EQ(counts().restarts, 1);
  EXPECT_EQ(counts().accepted, 3);
}

TEST_F(ScanIntakeTest, DropsReturnsOutOfBoundsAndKeepsTheScan) {
  auto far = scan(kSecond, 0);
  far.returns = {{0.0, 150.5, 1.0}, {0.0, 149.5, 1.0}};
  state(kSecond);
  intake_.add(far);
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_EQ(out_[0].scan.returns.size(), 1u);
  EXPECT_EQ(counts().dropped_returns, 1);
}

TEST_F(ScanIntakeTest, AcceptsAScanWithoutReturns) {
  surrounded_scan(kSecond);
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_TRUE(out_[0].scan.returns.empty());
}

TEST_F(ScanIntakeTest, NinetyReturnsThatAreAllNanAreNinetySilences) {
  auto silent = scan(kSecond, 0);
  silent.returns.assign(
      90, {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), 1.0});
  state(kSecond);
  intake_.add(silent);
  EXPECT_EQ(counts().silent_returns, 90);
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_TRUE(out_[0].scan.returns.empty());
}

TEST_F(ScanIntakeTest, LetsTheGeometryOfTheMessageWinAndSaysSo) {
  auto other = scan(kSecond, 0);
  other.max_range = 75.0;
  state(kSecond);
  intake_.add(other);
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_EQ(out_[0].scan.max_range, 75.0);
  EXPECT_EQ(counts().other_geometry, 1);
  EXPECT_EQ(reports_.size(), 1u);
}

TEST_F(ScanIntakeTest, SaysFewLinesAboutManyBadScans) {
  surrounded_scan(kHour);
  for (int i = 0; i < 1000; ++i) intake_.add(scan(kHour, 0));
  EXPECT_EQ(counts().out_of_time, 1000);
  EXPECT_EQ(reports_.size(), 10u);  // 1, 2, 4, ... 512.
}

TEST_F(ScanIntakeTest, AFloodWithoutStatesIsBounded) {
  for (int i = 0; i < 3000; ++i) intake_.add(scan(i, i));  // A microsecond apart: none waits over a second.
  EXPECT_EQ(counts().no_pose, 3000 - 1024);
}

TEST_F(ScanIntakeTest, RejectsWhatStillWaitsAtTheEnd) {
  state(0);
  intake_.add(scan(kSecond / 2, 0));
  intake_.finish();
  EXPECT_EQ(counts().no_pose, 1);
}

TEST(ScanIntake, RefusesParamsOutOfRange) {
  const auto with = [](const IntakeParams& params) { return ScanIntake(core::SonarParams(), {}, params); };
  EXPECT_THROW(with({-1, 1, 1, {}}), std::invalid_argument);
  EXPECT_THROW(with({0, 0, 1, {}}), std::invalid_argument);
}

TEST(ImageIntake, PosesImagesByTheSameRules) {
  std::vector<double> north;
  ImageIntake intake(core::SonarParams(),
                     {[&](const core::PosedImage& posed) { north.push_back(posed.T_earth_sonar.north); },
                      [] {}, [](const std::string&) {}});
  core::SonarImage image;
  image.utime = kSecond;
  image.bearings = {0.0};
  image.range_step = 1.0;
  image.num_bins = 1;
  image.intensity = {1.0};
  intake.add(core::VehicleState{0, {0.0, 0.0, 0.0}, {0.0, 0.0}});
  intake.add(image);
  intake.add(core::VehicleState{2 * kSecond, {2.0, 0.0, 0.0}, {0.0, 0.0}});
  ASSERT_EQ(north.size(), 1u);
  EXPECT_NEAR(north[0], 1.0, 1e-9);
}

// Table 1's outer beams, the 88 between them even in the sine: a message can only say the mean.
TEST_F(ScanIntakeTest, BeamsThatAreEvenInSineAreFoundAndToldOnce) {
  const double outer = std::sin(core::radians(44.5));
  for (int i = 0; i < 8; ++i) {
    core::SonarScan one = scan(i * kSecond, i);
    for (const int beam : {10 + i, 40 + i})
      one.returns.push_back({std::asin(outer * (2.0 * beam / 89.0 - 1.0)), 50.0 + i, 1.0});
    state(i * kSecond);
    intake_.add(one);
  }
  ASSERT_EQ(out_.size(), 8u);
  EXPECT_FALSE(out_.front().scan.fan);
  ASSERT_TRUE(out_.back().scan.fan);
  EXPECT_NEAR(out_.back().scan.fan->place_of(out_.back().scan.returns[0].bearing), 17.0, 1e-6);
  EXPECT_EQ(std::count_if(reports_.begin(), reports_.end(),
                          [](const auto& line) { return line.find("even in sine") != std::string::npos; }),
            1);
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
