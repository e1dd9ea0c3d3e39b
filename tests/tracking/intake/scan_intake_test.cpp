#include "tracking/intake/scan_intake.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "tests/tracking/intake/intake_bench.hpp"

namespace lookout::tracking {
namespace {

class ScanIntakeTest : public IntakeBench {};

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

TEST_F(ScanIntakeTest, AcceptsAScanWithoutReturns) {
  surrounded_scan(kSecond);
  ASSERT_EQ(out_.size(), 1u);
  EXPECT_TRUE(out_[0].scan.returns.empty());
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

}  // namespace
}  // namespace lookout::tracking
