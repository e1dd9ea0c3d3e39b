#include "tracking/intake/ping_checks.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace lookout::tracking {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

core::SonarScan good_scan() {  // Three beams of 0.1 rad around the axis.
  core::SonarScan scan;
  scan.first_bearing = -0.1;
  scan.bearing_step = 0.1;
  scan.max_range = 100.0;
  scan.num_beams = 3;
  scan.returns = {{0.0, 50.0, 1.0}};
  return scan;
}

core::SonarImage good_image() {
  core::SonarImage image;
  image.bearings = {0.0, 0.1};
  image.range_step = 1.0;
  image.num_bins = 2;
  image.intensity = {1, 2, 3, 4};
  return image;
}

TEST(PingChecks, PassWhatIsGood) {
  EXPECT_EQ(defect(good_scan()), "");
  EXPECT_EQ(defect(good_image()), "");
  EXPECT_EQ(defect(core::VehicleState{}), "");
}

TEST(PingChecks, NameTheDefectOfAScan) {
  const auto broken = [](auto change) {
    auto scan = good_scan();
    change(scan);
    return defect(scan);
  };
  EXPECT_EQ(broken([](auto& s) { s.utime = std::numeric_limits<std::int64_t>::max(); }), "time out of range");
  EXPECT_EQ(broken([](auto& s) { s.num_beams = 0; }), "number of beams out of range");
  EXPECT_EQ(broken([](auto& s) { s.bearing_step = -0.1; }), "bearings out of range");
  EXPECT_EQ(broken([](auto& s) { s.bearing_step = kNan; }), "bearings out of range");
  EXPECT_EQ(broken([](auto& s) { s.num_beams = 100; }), "bearings out of range");  // 10 rad in all.
  EXPECT_EQ(broken([](auto& s) { s.max_range = 1e300; }), "maximum range out of range");
  EXPECT_EQ(broken([](auto& s) { s.max_range = 0.05; }),
            "maximum range out of range");  // Nor in a sonar.yaml.
  EXPECT_EQ(broken([](auto& s) { s.T_body_sonar.heading = kNan; }), "mount out of range");
  EXPECT_EQ(broken([](auto& s) { s.returns[0].range = kNan; }), "");  // A silence.
}

TEST(PingChecks, NameTheDefectOfAnImageAndOfAState) {
  auto image = good_image();
  image.bearings = {0.1, 0.0};
  EXPECT_EQ(defect(image), "bearings out of range");
  image.bearings.clear();
  EXPECT_EQ(defect(image), "number of beams out of range");
  image = good_image();
  image.num_bins = 3;
  EXPECT_EQ(defect(image), "sizes disagree");
  image = good_image();
  image.intensity[3] = kNan;
  EXPECT_EQ(defect(image), "an intensity is not finite");
  core::VehicleState state;
  state.T_earth_body.east = kNan;
  EXPECT_EQ(defect(state), "pose out of range");
  state = {};
  state.velocity.x() = 1e300;
  EXPECT_EQ(defect(state), "velocity out of range");
}

TEST(PingChecks, DropReturnsOutOfRangeAndOutOfSector) {
  auto scan = good_scan();  // The sector's edges are at -0.15 and 0.15.
  scan.returns = {{0.0, 100.0, 1}, {0.0, 100.1, 1}, {0.0, 0.0, 1},   {0.0, -5.0, 1},
                  {0.14, 50.0, 1}, {0.16, 50.0, 1}, {-0.16, 50.0, 1}};
  const DroppedReturns dropped = drop_returns(scan);
  EXPECT_EQ(dropped.out_of_bounds, 4);
  EXPECT_EQ(dropped.silent, 1);  // Range 0.
  ASSERT_EQ(scan.returns.size(), 2u);
  EXPECT_EQ(scan.returns[0].range, 100.0);
  EXPECT_EQ(scan.returns[1].bearing, 0.14);
}

TEST(PingChecks, TakeWhatIsNotFiniteForASilence) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  auto scan = good_scan();
  scan.returns = {{0.0, kInf, 1}, {0.0, -kInf, 1},  {0.0, kNan, 1},
                  {kNan, 5.0, 1}, {0.0, 5.0, kNan}, {0.0, 5.0, 1}};
  const DroppedReturns dropped = drop_returns(scan);
  EXPECT_EQ(dropped.silent, 4);
  EXPECT_EQ(dropped.out_of_bounds, 0);
  ASSERT_EQ(scan.returns.size(), 2u);
  EXPECT_EQ(scan.returns[0].intensity, 1.0);  // Whose intensity nobody knows is heard none the less.
}

TEST(PingChecks, TakeSeveralAtTheVeryMaximumForSilencesAndOneForAnEcho) {
  auto scan = good_scan();
  scan.returns = {{0.0, 100.0, 1}, {0.1, 100.0, 1}, {0.0, 40.0, 1}};
  EXPECT_EQ(drop_returns(scan).silent, 0);
  scan.returns.push_back({0.05, 100.0, 1});
  EXPECT_EQ(drop_returns(scan).silent, 3);
  EXPECT_EQ(scan.returns.size(), 1u);
}

TEST(PingChecks, NoticeAValueOfADriversOwnForSilence) {
  auto scan = good_scan();
  scan.returns.assign(7, {0.0, 65.535, 1});
  EXPECT_EQ(same_range(scan).count, 0);
  for (int i = 0; i < 6; ++i) scan.returns.insert(scan.returns.begin() + i, {0.0, 10.0 + i, 1});
  EXPECT_EQ(same_range(scan).count, 7);
  EXPECT_EQ(same_range(scan).range, 65.535);
  scan.returns.push_back({0.0, 20.0, 1});
  EXPECT_EQ(same_range(scan).count, 0);  // Half of them are not most.
}

TEST(PingChecks, TurnBearingsOfAnotherTurnIntoTheSector) {
  auto scan = good_scan();
  scan.returns = {{0.05 + 2.0 * std::numbers::pi, 50.0, 1}, {1e300, 50.0, 1}};
  EXPECT_EQ(drop_returns(scan).out_of_bounds, 1);
  EXPECT_NEAR(scan.returns.at(0).bearing, 0.05, 1e-12);
}

TEST(PingChecks, CompareTheGeometryWithTheConfiguration) {
  core::SonarParams params;
  core::SonarScan scan;
  scan.first_bearing = params.first_bearing;
  scan.bearing_step = params.bearing_step;
  scan.num_beams = params.num_beams;
  scan.max_range = params.max_range;
  EXPECT_TRUE(agrees(scan, params));
  scan.max_range += 1.0;
  EXPECT_FALSE(agrees(scan, params));
}

}  // namespace
}  // namespace lookout::tracking
