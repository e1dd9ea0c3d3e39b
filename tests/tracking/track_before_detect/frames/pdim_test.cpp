#include "tracking/track_before_detect/frames/pdim.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace lookout::tracking {
namespace {

TEST(Pdim, EitherPolarityShowsThePresentPlace) {
  core::Random random(1);
  const std::vector<double> sky(16, 100.0);
  std::vector<double> earlier = sky, later = sky;
  earlier[0] = 36.0;  // a dark object that moves from cell 0 to cell 5
  later[5] = 36.0;
  const auto dark = pdim_frame(earlier, later, 4, 4, {Polarity::dark, 1.0, false}, random);
  EXPECT_DOUBLE_EQ(dark.values[5], 8.0);  // root of a contrast of 64
  EXPECT_LT(dark.values[0], 1.5);
  const auto bright = pdim_frame(earlier, later, 4, 4, {Polarity::bright, 1.0, false}, random);
  EXPECT_DOUBLE_EQ(bright.values[0], 8.0);  // the printed sign would show where it was
}

TEST(Pdim, UnchangedPixelsHoldTheNoiseLevel) {
  core::Random random(2);
  const std::vector<double> sky(40000, 100.0);
  const auto frame = pdim_frame(sky, sky, 200, 200, {Polarity::dark, 1.259, false}, random);
  double mean = 0.0;
  for (const double value : frame.values) mean += value / 40000.0;
  EXPECT_NEAR(mean, 1.259, 0.01);  // E sqrt(noise^2 - 1/2 + U(0, 1)), noise to within 1 %
}

TEST(Pdim, ThePrintedFloorLetsSmallDifferencesUnderTheNoise) {
  core::Random random(3);
  const std::vector<double> earlier(4, 100.0), later(4, 99.99);
  EXPECT_NEAR(pdim_frame(earlier, later, 2, 2, {Polarity::dark, 1.0, true}, random).values[0], 0.1, 1e-9);
  EXPECT_GE(pdim_frame(earlier, later, 2, 2, {Polarity::dark, 1.0, false}, random).values[0], std::sqrt(0.5));
}

TEST(Pdim, RefusesBadFrames) {
  core::Random random(4);
  const std::vector<double> four(4, 1.0), three(3, 1.0);
  EXPECT_THROW(pdim_frame(four, three, 2, 2, {}, random), std::invalid_argument);
  EXPECT_THROW(pdim_frame(four, four, 2, 2, {Polarity::dark, 0.1, false}, random), std::invalid_argument);
  const std::vector<double> bad{1.0, std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0};
  EXPECT_NO_THROW(pdim_frame(four, four, 2, 2, {}, random));
  EXPECT_THROW(pdim_frame(four, bad, 2, 2, {}, random), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
