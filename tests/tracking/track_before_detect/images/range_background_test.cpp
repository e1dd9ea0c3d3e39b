#include "tracking/track_before_detect/images/range_background.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/beam_bearings.hpp"

namespace lookout::tracking {
namespace {

/// Level 10 / (1 + bin) in each of nine beams.
core::SonarImage falling_level() {
  core::SonarImage image;
  image.bearings = core::even_bearings(-0.04, 0.01, 9);
  image.num_bins = 40;
  for (int beam = 0; beam < 9; ++beam)
    for (int bin = 0; bin < 40; ++bin) image.intensity.push_back(10.0 / (1.0 + 0.02 * bin));
  return image;
}

TEST(RangeBackground, TakesOutTheLevelOfEachRange) {
  RangeBackground background({3});
  const IntensityFrame& frame = background.normalise(falling_level());
  EXPECT_EQ(frame.columns, 40);
  EXPECT_EQ(frame.rows, 9);
  for (int bin = 3; bin < 37; ++bin)
    EXPECT_NEAR(frame.at(bin, 4), 1.0, 1e-12);  // a monotone level is its median
}

TEST(RangeBackground, ATargetInOneBeamStandsOut) {
  core::SonarImage image = falling_level();
  image.intensity[4 * 40 + 20] *= 5.0;
  RangeBackground background({3});
  EXPECT_NEAR(background.normalise(image).at(20, 4), 5.0, 1e-12);
}

TEST(RangeBackground, AnEmptyImageIsDark) {
  core::SonarImage image = falling_level();
  image.intensity.assign(image.intensity.size(), 0.0);
  RangeBackground background;
  for (const double value : background.normalise(image).values) EXPECT_EQ(value, 0.0);
}

TEST(RangeBackground, RefusesANegativeWindow) {
  EXPECT_THROW(RangeBackground({-1}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
