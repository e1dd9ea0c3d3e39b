#include "tracking/track_before_detect/frames/frame_preparation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace lookout::tracking {
namespace {

std::vector<double> noise(std::uint64_t seed, double mean, double sigma) {
  core::Random random(seed);
  std::vector<double> values(10000);
  for (double& value : values) value = mean + random.gaussian(sigma);
  return values;
}

TEST(FramePreparation, NoiseDoesNotAgreeWithItselfAndASceneDoes) {
  const auto a = noise(1, 1000, 50), b = noise(2, 1000, 50);
  EXPECT_NEAR(quadrant_correlation(a, b), 0.0, 0.05);
  EXPECT_NEAR(quadrant_correlation(a, a), 1.0, 0.01);
  std::vector<double> flat(10000, 7.0);
  flat[5] = 100.0;  // a flat field with one object is no standing scene
  EXPECT_EQ(quadrant_correlation(flat, flat), 0.0);
}

TEST(FramePreparation, RobustSigmaIgnoresAFewBrightPixels) {
  auto values = noise(3, 0, 10);
  for (int i = 0; i < 100; ++i) values[static_cast<std::size_t>(i)] = 1e4;
  EXPECT_NEAR(robust_sigma(values), 10.0, 0.5);
  EXPECT_EQ(robust_sigma(std::vector<double>(10, 3.0)), 1.0);
}

TEST(FramePreparation, StandardisedFrameHoldsTheExcessInSigmas) {
  auto values = noise(4, 1000, 50);
  values[50] = 1500.0;
  EXPECT_NEAR(standardised_frame(values, 100, 100, Polarity::bright).values[50], 10.0, 0.5);
  EXPECT_EQ(standardised_frame(values, 100, 100, Polarity::dark).values[50], 0.0);
}

TEST(FramePreparation, ScaledPdimKeepsItsNoiseLevelInNoise) {
  core::Random random(5);
  const auto earlier = noise(6, 1000, 50), later = noise(7, 1000, 50);
  const IntensityFrame frame = scaled_pdim_frame(earlier, later, 100, 100, Polarity::bright, random);
  EXPECT_NEAR(frame.noise_level, 1.0, 0.1);
}

TEST(FramePreparation, RefusesWhatIsNotFinite) {
  std::vector<double> values(4, 1.0);
  values[2] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(standardised_frame(values, 2, 2, Polarity::bright), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
