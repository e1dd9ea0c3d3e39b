#include "tracking/track_before_detect/images/image_background.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/beam_bearings.hpp"

namespace lookout::tracking {
namespace {

constexpr int kBeams = 31;
constexpr int kBins = 60;

/// A level that falls over range, times a gain of each beam: beam 7 has three times that of the others.
core::PosedImage striped() {
  core::PosedImage posed;
  posed.image.num_bins = kBins;
  posed.image.bearings = core::even_bearings(-0.3, 0.02, kBeams);
  posed.image.first_range = 5.0;
  posed.image.range_step = 0.5;
  for (int beam = 0; beam < kBeams; ++beam)
    for (int bin = 0; bin < kBins; ++bin)
      posed.image.intensity.push_back((beam == 7 ? 3.0 : 1.0) * 10.0 / (1.0 + 0.02 * bin));
  return posed;
}

std::size_t cell(int bin, int beam) {
  return static_cast<std::size_t>(beam * kBins + bin);
}

TEST(ImageBackground, TakesOutTheLevelOfRangesAndTheGainOfBeams) {
  ImageBackground background;
  const IntensityFrame& frame = background.normalise(striped());
  EXPECT_EQ(frame.columns, kBins);
  EXPECT_EQ(frame.rows, kBeams);
  for (int bin = 8; bin < kBins - 8; ++bin)
    for (const int beam : {4, 7}) EXPECT_NEAR(frame.at(bin, beam), 1.0, 1e-9) << bin << " " << beam;
}

TEST(ImageBackground, ATargetStandsOutAndAHighlightThatStandsFades) {
  ImageBackground background;
  core::PosedImage posed = striped();
  posed.image.intensity[cell(20, 15)] *= 8.0;
  EXPECT_NEAR(background.normalise(posed).at(20, 15), 8.0, 1e-9);
  for (int ping = 0; ping < 40; ++ping) {
    background.learn({}, {});
    background.normalise(posed);
  }
  EXPECT_LT(background.normalise(posed).at(20, 15), 1.2);
}

TEST(ImageBackground, WhatATargetCoversIsNotLearntUntilItIsSaidToStand) {
  ImageBackground background;
  core::PosedImage posed = striped();
  posed.image.intensity[cell(20, 15)] *= 8.0;
  const CellWindow window{18, 23, 14, 17};
  for (int ping = 0; ping < 40; ++ping) {
    background.normalise(posed);
    background.learn({&window, 1}, {});
  }
  EXPECT_NEAR(background.normalise(posed).at(20, 15), 8.0, 1e-6);
  background.learn({}, {&window, 1});
  EXPECT_LT(background.normalise(posed).at(20, 15), 1.5);
}

TEST(ImageBackground, TheMemoryMovesWithTheSonar) {
  ImageBackground background;
  core::PosedImage posed = striped();
  posed.image.intensity[cell(20, 15)] *= 8.0;  // at 15 m on beam 15, which looks ahead
  for (int ping = 0; ping < 40; ++ping) {
    background.normalise(posed);
    background.learn({}, {});
  }
  core::PosedImage nearer = striped();
  nearer.T_earth_sonar.north = 1.0;  // two bins
  nearer.image.intensity[cell(18, 15)] *= 8.0;
  EXPECT_LT(background.normalise(nearer).at(18, 15), 1.5);
}

TEST(ImageBackground, AnotherGeometryStartsAnew) {
  ImageBackground background;
  background.normalise(striped());
  background.learn({}, {});
  core::PosedImage other = striped();
  other.image.range_step = 0.25;
  EXPECT_NEAR(background.normalise(other).at(30, 4), 1.0, 1e-9);
}

TEST(ImageBackground, AnEmptyImageIsDark) {
  core::PosedImage posed = striped();
  posed.image.intensity.assign(posed.image.intensity.size(), 0.0);
  ImageBackground background;
  for (const double value : background.normalise(posed).values) EXPECT_EQ(value, 0.0);
}

TEST(ImageBackground, RefusesParametersOutOfRange) {
  ImageBackgroundParams params;
  params.least_half_window = -1;
  EXPECT_THROW(ImageBackground{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
