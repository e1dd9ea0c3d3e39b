#include "tracking/restart/clock_step.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

constexpr double kSpeed = 1.0;        // m/s, of a vehicle that is under way
constexpr std::int64_t kHour = 3600;  // s

/// The scan of that number, half a second a number, from a vehicle at `north` [m].
core::RememberedScan scan_at(std::int64_t sequence, double second, double north) {
  core::RememberedScan one;
  one.vehicle.T_earth_body.north = north;
  one.scan.utime = one.vehicle.utime = core::microseconds(second);
  one.scan.sequence = sequence;
  return one;
}

/// Scans 0 to 39, of 20 s.
std::vector<core::RememberedScan> before(double speed) {
  std::vector<core::RememberedScan> scans;
  for (int i = 0; i < 40; ++i) scans.push_back(scan_at(i, 0.5 * i, speed * 0.5 * i));
  return scans;
}

TEST(ClockStep, BackIsAClockThatWasSetWhereNumbersGoOn) {
  const auto step = clock_step(before(0.0), scan_at(42, 21.0 - kHour, 0.0));
  ASSERT_TRUE(step);
  EXPECT_EQ(*step, core::microseconds(-static_cast<double>(kHour)));
  EXPECT_FALSE(clock_step(before(0.0), scan_at(0, -100.0, 0.0)));   // The numbers start again.
  EXPECT_FALSE(clock_step(before(0.0), scan_at(90, -100.0, 0.0)));  // 25 s without a scan.
}

TEST(ClockStep, AheadItWasSetWhereAVehicleUnderWayIsWhereItWas) {
  const auto step = clock_step(before(kSpeed), scan_at(42, 21.0 + kHour, 21.0 * kSpeed));
  ASSERT_TRUE(step);
  EXPECT_EQ(*step, core::microseconds(static_cast<double>(kHour)));
}

TEST(ClockStep, AheadItMayHaveSlept) {
  EXPECT_FALSE(clock_step(before(0.0), scan_at(42, 21.0 + kHour, 0.0)));        // At anchor.
  EXPECT_FALSE(clock_step(before(kSpeed), scan_at(42, 21.0 + kHour, 3600.0)));  // It went on.
  EXPECT_FALSE(clock_step(before(kSpeed), scan_at(42, 21.0 + 90.0, 21.0)));     // It may have turned.
  const std::vector<core::RememberedScan> few{scan_at(0, 0.0, 0.0), scan_at(1, 0.5, 0.5)};
  EXPECT_FALSE(clock_step(few, scan_at(2, 1.0 + kHour, 1.0)));  // Its speed is hardly known.
}

TEST(ClockStep, AnotherSensorsNumbersSayNothing) {
  core::RememberedScan other = scan_at(42, 21.0 - kHour, 0.0);
  other.scan.sensor_id = 2;
  EXPECT_FALSE(clock_step(before(0.0), other));
  EXPECT_FALSE(clock_step({}, other));
}

}  // namespace
}  // namespace lookout::tracking
