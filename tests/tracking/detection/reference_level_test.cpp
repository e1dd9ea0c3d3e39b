#include "tracking/detection/reference_level.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>

#include "tests/tracking/detection/planes.hpp"

namespace lookout::tracking {
namespace {

using lookout::testing::flat;
using lookout::testing::set;

float level_at(const std::string& method, const ImagePlane& plane, int beam, int bin) {
  ReferenceParams params;
  params.method = method;
  const auto reference = make_reference_level(params);
  reference->prepare(plane, window_for({1.0, 1.0}, params, plane.num_beams, plane.num_bins));
  return reference->at(beam, bin);
}

ImagePlane speckle() {
  ImagePlane plane = flat(60, 200);
  std::mt19937 random(1);
  for (float& value : plane.values) value = std::exponential_distribution<float>(0.5F)(random);
  return plane;
}

class EveryReferenceLevel : public ::testing::TestWithParam<std::string> {};

// Exponential power of mean 2. A quantile of 32 samples errs by 0.75 / sqrt(32) / ln 4 / 0.25 of the mean or
// so, a fifth; the mean over ten cells by a third of that.
TEST_P(EveryReferenceLevel, IsTheMeanOfExponentialSpeckle) {
  const ImagePlane plane = speckle();
  double sum = 0.0;
  for (int bin = 20; bin < 180; ++bin) sum += level_at(GetParam(), plane, 30, bin);
  EXPECT_NEAR(sum / 160, 2.0, 0.3);
}

TEST_P(EveryReferenceLevel, LeavesOutTheEchoItself) {
  ImagePlane plane = flat(30, 100);
  for (int beam = 14; beam <= 16; ++beam)
    for (int bin = 49; bin <= 51; ++bin) set(plane, beam, bin, 1000.0F);
  const float level = level_at(GetParam(), plane, 15, 50);
  EXPECT_NEAR(level, GetParam() == kOrderedStatistic ? 0.72F : 1.0F,
              0.01F);  // 1 / ln 4: all cells are equal.
}

TEST_P(EveryReferenceLevel, HasALevelInEveryCorner) {
  const ImagePlane plane = speckle();
  for (const int beam : {0, 59})
    for (const int bin : {0, 199}) EXPECT_GT(level_at(GetParam(), plane, beam, bin), 0.5F);
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryReferenceLevel, ::testing::ValuesIn(reference_level_names()));

/// A level with a strong echo of 3 x 3 cells beyond the guard.
ImagePlane with_neighbour() {
  ImagePlane plane = flat(30, 100);
  for (int beam = 14; beam <= 16; ++beam)
    for (int bin = 55; bin <= 57; ++bin) set(plane, beam, bin, 1000.0F);
  return plane;
}

TEST(ReferenceLevel, ANeighbourSpoilsTheMeanAlone) {
  const ImagePlane plane = with_neighbour();
  EXPECT_GT(level_at("cell_averaging", plane, 15, 50), 20.0F);
  EXPECT_NEAR(level_at("smallest_of", plane, 15, 50), 1.0F, 0.01F);
  EXPECT_NEAR(level_at("ordered_statistic", plane, 15, 50), 0.72F, 0.01F);
}

TEST(ReferenceLevel, AnUnknownNameIsRefusedWithThoseThatAre) {
  ReferenceParams params;
  params.method = "median";
  try {
    make_reference_level(params);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("ordered_statistic"), std::string::npos);
  }
}

}  // namespace
}  // namespace lookout::tracking
