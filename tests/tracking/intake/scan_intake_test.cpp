#include "tracking/intake/scan_intake.hpp"

#include <gtest/gtest.h>

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
  EXPECT_EQ(reports_[0], "scan at 0 s rejected: no pose (1 so far)");
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
  EXPECT_EQ(counts().no_pose, 1);
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
  for (const std::int64_t jump : {kHour, -kHour}) {
    SCOPED_TRACE(jump);
    const std::int64_t start = 10 * kHour + (jump < 0 ? 2 * kHour : 0);
    resets_ = 0;
    for (int i = 0; i < 8; ++i) surrounded_scan(start + i * kSecond);
    const auto before = out_.size();
    const auto rejected = counts().out_of_time;
    for (int i = 0; i < 8; ++i) surrounded_scan(start + jump + i * kSecond);
    EXPECT_EQ(resets_, 1);
    EXPECT_EQ(counts().out_of_time - rejected, 4);
    EXPECT_EQ(out_.size() - before, 4u);  // The fifth, which begins the new clock, to the eighth.
    intake_ =
        ScanIntake(core::SonarParams(), {[this](const core::PosedScan& posed) { out_.push_back(posed); },
                                         [this] { ++resets_; }, [](const std::string&) {}});
  }
}

TEST_F(ScanIntakeTest, FindsThePoseOnANewClockThoughStatesAreFewerThanScans) {
  for (int i = 0; i < 3; ++i) surrounded_scan(kHour + i * kSecond);
  // One state a second, ten scans a second: the scans' clock is believed before the states' own would be.
  state(0);
  for (int i = 1; i <= 9; ++i) intake_.add(scan(i * kSecond / 10, i));
  state(kSecond);
  EXPECT_EQ(resets_, 1);
  EXPECT_EQ(counts().accepted, 3 + 5);
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

TEST_F(ScanIntakeTest, RejectsNinetyReturnsThatAreAllNan) {
  auto broken = scan(kSecond, 0);
  broken.returns.assign(
      90, {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), 1.0});
  state(kSecond);
  intake_.add(broken);
  EXPECT_EQ(counts().damaged, 1);
  EXPECT_TRUE(out_.empty());
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
  for (int i = 0; i < 1000; ++i) intake_.add(scan(i, i));  // A microsecond apart: none waits over a second.
  EXPECT_EQ(counts().no_pose, 1000 - 256);
}

TEST_F(ScanIntakeTest, RejectsWhatStillWaitsAtTheEnd) {
  state(0);
  intake_.add(scan(kSecond / 2, 0));
  intake_.finish();
  EXPECT_EQ(counts().no_pose, 1);
}

TEST(ScanIntake, RefusesParamsOutOfRange) {
  const auto with = [](const IntakeParams& params) { return ScanIntake(core::SonarParams(), {}, params); };
  EXPECT_THROW(with({-1, 1, {}}), std::invalid_argument);
  EXPECT_THROW(with({0, 0, {}}), std::invalid_argument);
}

TEST(ImageIntake, PosesImagesByTheSameRules) {
  std::vector<double> north;
  ImageIntake intake(core::SonarParams(),
                     {[&](const core::PosedImage& posed) { north.push_back(posed.T_earth_sonar.north); },
                      [] {}, [](const std::string&) {}});
  core::SonarImage image;
  image.utime = kSecond;
  image.bearing_step = 0.1;
  image.range_step = 1.0;
  image.num_beams = image.num_bins = 1;
  image.intensity = {1.0};
  intake.add(core::VehicleState{0, {0.0, 0.0, 0.0}, {0.0, 0.0}});
  intake.add(image);
  intake.add(core::VehicleState{2 * kSecond, {2.0, 0.0, 0.0}, {0.0, 0.0}});
  ASSERT_EQ(north.size(), 1u);
  EXPECT_NEAR(north[0], 1.0, 1e-9);
}

}  // namespace
}  // namespace lookout::tracking
