#include "csht/scan_to_detections.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "core/uneven_fan.hpp"

namespace lookout::csht {
namespace {

core::PosedScan scan_with(std::vector<core::SonarReturn> returns) {
  core::PosedScan posed;
  posed.scan.utime = 42;
  posed.scan.first_bearing = core::radians(-44.5);
  posed.scan.bearing_step = core::radians(1.0);
  posed.scan.num_beams = 90;
  posed.scan.max_range = 150.0;
  posed.scan.returns = std::move(returns);
  posed.T_earth_sonar = {10.0, 20.0, core::radians(90.0)};
  return posed;
}

TEST(ScanToDetections, PlacesAReturnInTheEarthFrame) {
  std::vector<core::Detection> detections;
  EXPECT_EQ(scan_to_detections(scan_with({{core::radians(0.5), 30.0, 1.0}}), 4, detections), 0);
  ASSERT_EQ(detections.size(), 1u);
  EXPECT_EQ(detections[0].beam, 45);
  EXPECT_EQ(detections[0].scan, 4);
  EXPECT_EQ(detections[0].utime, 42);
  // Looking east, half a degree to starboard: 30 m east and 30 sin(0.5 deg) south. By hand.
  EXPECT_NEAR(detections[0].p_earth.y(), 20.0 + 30.0 * std::cos(core::radians(0.5)), 1e-12);
  EXPECT_NEAR(detections[0].p_earth.x(), 10.0 - 30.0 * std::sin(core::radians(0.5)), 1e-12);
}

TEST(ScanToDetections, LeavesOutAndCountsWhatCannotBe) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<core::Detection> detections;
  EXPECT_EQ(scan_to_detections(scan_with({{0, 151.0, 1}, {0, 0.0, 1}, {0, nan, 1}, {nan, 5.0, 1}, {0, 5, 1}}),
                               0, detections),
            4);
  EXPECT_EQ(detections.size(), 1u);
}

TEST(ScanToDetections, UnevenBeamsAreThoseOfTheNearestCentre) {
  core::PosedScan scan = scan_with({{core::radians(-5.9), 5, 1}, {core::radians(-6.1), 5, 1}});
  scan.scan.num_beams = 4;
  scan.scan.fan = std::make_shared<const core::UnevenFan>(
      std::vector{core::radians(-10.0), core::radians(-2.0), 0.0, core::radians(10.0)});
  std::vector<core::Detection> detections;
  scan_to_detections(scan, 0, detections);
  EXPECT_EQ(detections[0].beam, 1);
  EXPECT_EQ(detections[1].beam, 0);
}

}  // namespace
}  // namespace lookout::csht
