#include "core/uneven_fan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "core/beam_bearings.hpp"
#include "core/frames.hpp"

namespace lookout::core {
namespace {

std::vector<double> in_radians(std::vector<double> degrees) {
  for (double& bearing : degrees) bearing = radians(bearing);
  return degrees;
}

// Centres at -10, -2, 0, 10 degrees: edges at -6, -1 and 5; the outer ones 4 and 5 degrees outside.
TEST(UnevenFan, BeamsMeetMidwayBetweenTheirCentres) {
  const UnevenFan fan(in_radians({-10, -2, 0, 10}));
  EXPECT_EQ(fan.beam_of(radians(-13.9)), 0);
  EXPECT_EQ(fan.beam_of(radians(-14.1)), -1);
  EXPECT_EQ(fan.beam_of(radians(-6.1)), 0);
  EXPECT_EQ(fan.beam_of(radians(-5.9)), 1);
  EXPECT_EQ(fan.beam_of(radians(-0.9)), 2);
  EXPECT_EQ(fan.beam_of(radians(5.1)), 3);
  EXPECT_EQ(fan.beam_of(radians(14.9)), 3);
  EXPECT_EQ(fan.beam_of(radians(15.1)), -1);
}

TEST(UnevenFan, WidthsAreFromMidwayToMidway) {
  const UnevenFan fan(in_radians({-10, -2, 0, 10}));
  EXPECT_NEAR(degrees(fan.width(0)), 8.0, 1e-12);
  EXPECT_NEAR(degrees(fan.width(1)), 5.0, 1e-12);
  EXPECT_NEAR(degrees(fan.width(2)), 6.0, 1e-12);
  EXPECT_NEAR(degrees(fan.width(9)), 10.0, 1e-12);
  EXPECT_NEAR(degrees(fan.narrowest()), 5.0, 1e-12);
  EXPECT_NEAR(degrees(fan.mean_step()), 20.0 / 3.0, 1e-12);
  EXPECT_NEAR(degrees(fan.sector()), 29.0, 1e-12);  // 20 between the outer centres, 4 and 5 outside.
}

TEST(UnevenFan, AFanAcrossAsternIsUnwrapped) {
  const UnevenFan fan(in_radians({170, 175, 190}));
  EXPECT_EQ(fan.beam_of(radians(-175.0)), 2);  // 185 degrees
  EXPECT_EQ(fan.beam_of(radians(-178.5)), 1);  // 181.5 degrees
}

// The bins are a short cut alone: the table's own search is the reference.
TEST(UnevenFan, PlacesAreThoseOfTheTable) {
  std::vector<double> centres;
  for (int beam = 0; beam < 64; ++beam) centres.push_back(std::asin(-0.9 + 1.8 * beam / 63.0));
  centres.push_back(centres.back() + 1e-4);  // A very narrow beam beside a wide one.
  const UnevenFan fan(centres);
  for (int i = -1600; i <= 1600; ++i) {
    const double bearing = 0.001 * i;
    EXPECT_NEAR(fan.place_of(bearing), place_of(centres, bearing), 1e-9) << bearing;
    EXPECT_NEAR(fan.bearing_at(fan.place_of(bearing)), bearing, 1e-12) << bearing;
  }
  for (int beam = 0; beam < 65; ++beam) EXPECT_NEAR(fan.place_of(fan.centre(beam)), beam, 1e-9);
}

TEST(UnevenFan, FitsADescriptionByItsMean) {
  const UnevenFan fan(in_radians({-10, -2, 0, 10}));
  EXPECT_TRUE(fan.fits(4, radians(-10.0), radians(20.0 / 3.0)));
  EXPECT_TRUE(fan.fits(4, radians(-10.1), radians(6.7)));  // Rounded by a driver.
  EXPECT_FALSE(fan.fits(5, radians(-10.0), radians(5.0)));
  EXPECT_FALSE(fan.fits(4, radians(-10.0), radians(9.0)));
  EXPECT_FALSE(fan.fits(4, std::numeric_limits<double>::quiet_NaN(), radians(6.7)));
}

TEST(UnevenFan, IsTheSameByItsCentres) {
  const UnevenFan fan({0.0, 0.1, 0.3}), copy({0.0, 0.1, 0.3}), other({0.0, 0.2, 0.3});
  EXPECT_TRUE(same_fan(&fan, &copy));
  EXPECT_TRUE(same_fan(nullptr, nullptr));
  EXPECT_FALSE(same_fan(&fan, &other));
  EXPECT_FALSE(same_fan(&fan, nullptr));
}

TEST(UnevenFan, RefusesWhatIsNoTable) {
  EXPECT_THROW(UnevenFan({0.0}), std::invalid_argument);
  EXPECT_THROW(UnevenFan({0.1, 0.1}), std::invalid_argument);
  EXPECT_THROW(UnevenFan({0.0, 7.0}), std::invalid_argument);  // More than a turn.
}

}  // namespace
}  // namespace lookout::core
