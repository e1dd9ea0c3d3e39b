#include "tracking/intake/fan_finder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

constexpr int kBeams = 128;
const double kOuter = core::radians(60.0);

/// A scan that says the mean of its fan, with returns at these bearings [rad].
core::SonarScan scan_with(const std::vector<double>& bearings) {
  core::SonarScan scan;
  scan.num_beams = kBeams;
  scan.first_bearing = -kOuter;
  scan.bearing_step = 2.0 * kOuter / (kBeams - 1);
  scan.max_range = 100.0;
  for (const double bearing : bearings) scan.returns.push_back({bearing, 50.0, 1.0});
  return scan;
}

double even(int beam) {
  return -kOuter + beam * 2.0 * kOuter / (kBeams - 1);
}
double in_sine(int beam) {
  return std::asin(std::sin(kOuter) * (2.0 * beam / (kBeams - 1) - 1.0));
}

TEST(FanFinder, FourReturnsTellASineFanFromAnEvenOne) {
  FanFinder finder;
  const core::SonarScan two = scan_with({in_sine(12), in_sine(100)});
  EXPECT_FALSE(finder.fan_of(two, {}));
  EXPECT_FALSE(finder.learn(two));
  EXPECT_FALSE(finder.fan_of(two, {}));
  EXPECT_TRUE(finder.learn(two));
  EXPECT_FALSE(finder.learn(two));  // It is told once.
  const auto fan = finder.fan_of(two, {});
  ASSERT_TRUE(fan);
  EXPECT_NEAR(fan->centre(12), in_sine(12), 1e-12);
}

TEST(FanFinder, AnEvenFanAndBearingsOfTheirOwnStayEven) {
  core::Random random(1004);
  FanFinder quantised, free;
  for (int i = 0; i < 100; ++i) {
    const core::SonarScan at_centres = scan_with({even(random.index(kBeams)), even(random.index(kBeams))});
    quantised.fan_of(at_centres, {});
    EXPECT_FALSE(quantised.learn(at_centres));
    const core::SonarScan anywhere = scan_with({random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
    free.fan_of(anywhere, {});
    EXPECT_FALSE(free.learn(anywhere));
  }
}

TEST(FanFinder, OneStrayReturnDoesNotHideTheFan) {
  FanFinder finder;
  std::vector<double> bearings{0.5 * (in_sine(3) + in_sine(4))};
  for (int beam = 10; beam < 40; ++beam) bearings.push_back(in_sine(beam));
  finder.fan_of(scan_with(bearings), {});
  EXPECT_TRUE(finder.learn(scan_with(bearings)));
}

TEST(FanFinder, WhatIsConfiguredHoldsWhereTheMessageIsItsMean) {
  core::SonarParams configured;
  std::vector<double> centres;
  for (int beam = 0; beam < kBeams; ++beam)
    centres.push_back(kOuter * std::pow(2.0 * beam / (kBeams - 1) - 1.0, 3));
  configured.fan = std::make_shared<const core::UnevenFan>(centres);
  FanFinder finder;
  EXPECT_EQ(finder.fan_of(scan_with({}), configured), configured.fan);
  core::SonarScan other = scan_with({});
  other.num_beams = 64;
  EXPECT_FALSE(finder.fan_of(other, configured));  // The message wins.
  configured.clutter_per_scan = 3.0;
  EXPECT_FALSE(finder.fan_of(scan_with({}), configured));  // A sensor without beams.
}

TEST(FanFinder, AnotherGeometryIsLearntAnew) {
  FanFinder finder;
  const core::SonarScan four = scan_with({in_sine(12), in_sine(30), in_sine(40), in_sine(50)});
  finder.fan_of(four, {});
  ASSERT_TRUE(finder.learn(four));
  core::SonarScan narrower = four;
  narrower.bearing_step *= 0.5;
  EXPECT_FALSE(finder.fan_of(narrower, {}));
  EXPECT_FALSE(finder.fan_of(four, {}));
}

}  // namespace
}  // namespace lookout::tracking
