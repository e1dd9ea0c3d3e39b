#include "tracking/track_before_detect/images/image_background.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
  for (int ping = 0; ping < 15; ++ping) {
    background.normalise(posed);
    background.learn({&window, 1}, {});
  }
  EXPECT_NEAR(background.normalise(posed).at(20, 15), 8.0, 1e-6);
  background.learn({}, {&window, 1});
  EXPECT_LT(background.normalise(posed).at(20, 15), 1.5);
}

/// What a highlight is over the background after `pings` at `interval` [s], kept for a target throughout,
/// beside what it was at the first.
double kept_for(int pings, double interval, double range_step) {
  ImageBackground background;
  core::PosedImage posed = striped();
  posed.image.range_step = range_step;
  posed.image.intensity[cell(20, 15)] *= 8.0;
  const CellWindow window{18, 23, 14, 17};
  const double first = background.normalise(posed).at(20, 15);
  for (int ping = 0; ping < pings; ++ping) {
    posed.image.utime = core::microseconds(interval * ping);
    background.normalise(posed);
    background.learn({&window, 1}, {});
  }
  return background.normalise(posed).at(20, 15) / first;
}

// 5 bins of .5 m take the slowest target 8 s; 3 beams of .02 rad at 5.2 m, .31 m, take it 1 s.
TEST(ImageBackground, ACellIsKeptForAsLongAsTheSlowestTargetTakesToPassIt) {
  EXPECT_NEAR(kept_for(70, 0.1, 0.5), 1.0, 1e-6);
  EXPECT_LT(kept_for(90, 0.1, 0.5), 0.25);
  EXPECT_NEAR(kept_for(45, 0.02, 0.01), 1.0, 1e-6);
  EXPECT_LT(kept_for(70, 0.02, 0.01), 0.25);
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

/// Largest of an image over its background, but for its borders, after some pings on the way north at half a
/// bin a ping, where `brighten` is what stands in the sonar's frame.
template <class Brighten>
double brightest_under_way(const Brighten& brighten) {
  ImageBackground background;
  core::PosedImage posed = striped();
  brighten(posed.image);
  double most = 0.0;
  for (int ping = 0; ping < 40; ++ping) {
    posed.T_earth_sonar.north = 0.25 * ping;
    const IntensityFrame& frame = background.normalise(posed);
    background.learn({}, {});
    if (ping < 30) continue;
    for (int bin = 8; bin < kBins - 8; ++bin)
      for (int beam = 1; beam < kBeams - 1; ++beam) most = std::max(most, frame.at(bin, beam));
  }
  return most;
}

TEST(ImageBackground, TheGainOfABeamStaysWithTheSonarUnderWay) {
  EXPECT_NEAR(brightest_under_way([](core::SonarImage&) {}), 1.0, 0.05);
}

TEST(ImageBackground, ABottomThatGoesAlongIsBackground) {
  const auto bottom = [](core::SonarImage& image) {
    for (int beam = 0; beam < kBeams; ++beam)
      for (int bin = beam < kBeams / 2 ? 25 : 35; bin < kBins; ++bin) image.intensity[cell(bin, beam)] *= 5.0;
  };
  EXPECT_LT(brightest_under_way(bottom), 1.5);
}

// Under way at half a bin a ping: an echo on three beams that goes along, and a ring at its range.
TEST(ImageBackground, OfWhatGoesAlongARingIsBackgroundAndACompactEchoIsNot) {
  const auto blob = [](core::SonarImage& image) {
    for (int beam = 14; beam < 17; ++beam) image.intensity[cell(25, beam)] *= 8.0;
  };
  const auto ring = [](core::SonarImage& image) {
    for (int beam = 0; beam < kBeams; beam += 2) image.intensity[cell(25, beam)] *= 8.0;
  };
  EXPECT_GT(brightest_under_way(blob), 5.0);
  EXPECT_LT(brightest_under_way(ring), 1.5);
}

TEST(ImageBackground, AShadowOnHalfOfABeamLeavesItsGain) {
  ImageBackground background;
  core::PosedImage posed = striped();
  for (int bin = 32; bin < kBins; ++bin) posed.image.intensity[cell(bin, 4)] *= 0.1;
  EXPECT_NEAR(background.normalise(posed).at(10, 4), 1.0, 0.05);
}

// A wall comes before the far half of beam after beam, which lie in its shadow from then on.
TEST(ImageBackground, AShadowThatGrowsOverTheBeamsLeavesTheirGains) {
  ImageBackground background;
  double most = 0.0;
  for (int ping = 0; ping < 80; ++ping) {
    core::PosedImage posed = striped();
    for (int beam = 20; beam < std::min(kBeams, 20 + ping / 4); ++beam)
      for (int bin = 22; bin < kBins; ++bin) posed.image.intensity[cell(bin, beam)] *= 0.1;
    const IntensityFrame& frame = background.normalise(posed);
    for (int beam = 20; beam < kBeams; ++beam) most = std::max(most, frame.at(10, beam));
    background.learn({}, {});
  }
  EXPECT_LT(most, 1.1);
}

// Half of the beams, side by side, are louder at their far end. Then the sonar goes ten bins on.
TEST(ImageBackground, NewGroundIsExpectedToBeAsItsPlaceInTheImageWas) {
  ImageBackground background;
  core::PosedImage posed = striped();
  for (int beam = 8; beam < 23; ++beam)
    for (int bin = kBins - 10; bin < kBins; ++bin) posed.image.intensity[cell(bin, beam)] *= 3.0;
  for (int ping = 0; ping < 100; ++ping) {
    background.normalise(posed);
    background.learn({}, {});
  }
  posed.T_earth_sonar.north = 5.0;
  EXPECT_LT(background.normalise(posed).at(kBins - 3, 16), 1.1);
}

TEST(ImageBackground, WhatLeavesAShadowIsNoTarget) {
  ImageBackground background;
  core::PosedImage posed = striped();
  for (int bin = 20; bin < 24; ++bin) posed.image.intensity[cell(bin, 15)] *= 0.1;
  for (int ping = 0; ping < 60; ++ping) {
    background.normalise(posed);
    background.learn({}, {});
  }
  EXPECT_LE(background.normalise(striped()).at(22, 15), 1.0 / ImageBackgroundParams{}.least_share + 1e-6);
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
  params = {};
  params.spill = 1.5;
  EXPECT_THROW(ImageBackground{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
