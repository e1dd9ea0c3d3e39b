#include "tracking/detection/gain_background.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace lookout::tracking {
namespace {

constexpr int kBeams = 12, kBins = 50;

/// Amplitudes whose gain rises over the beams and whose level falls with range.
std::vector<double> striped() {
  std::vector<double> values;
  for (int beam = 0; beam < kBeams; ++beam)
    for (int bin = 0; bin < kBins; ++bin) values.push_back((1.0 + (beam * 7) % kBeams) / (1.0 + 0.1 * bin));
  return values;
}

TEST(GainBackground, TakesOutGainAndLevel) {
  GainBackground background({}, ImageValues::amplitude);
  const ImagePlane& plane = background.normalise(striped(), kBeams, kBins);
  // A product of gain and level is fitted but for the floor of 1e-3 of a range's power.
  for (const float value : plane.values) EXPECT_NEAR(value, 1.0F, 0.05F);
}

TEST(GainBackground, AnEchoStandsOut) {
  std::vector<double> values = striped();
  values[5 * kBins + 20] *= 10.0;
  GainBackground background({}, ImageValues::amplitude);
  const ImagePlane& plane = background.normalise(values, kBeams, kBins);
  // Of its 20 dB the means of its row of 50 and its column of 12 take 20 (1/50 + 1/12) = 2.1 dB.
  EXPECT_NEAR(10.0 * std::log10(plane.at(5, 20)), 17.9, 0.5);
}

TEST(GainBackground, PowerAndDecibelsSayTheSame) {
  std::vector<double> amplitude = striped(), power, decibel;
  for (const double value : amplitude) {
    power.push_back(value * value);
    decibel.push_back(20.0 * std::log10(value));
  }
  GainBackground a({}, ImageValues::amplitude), b({}, ImageValues::power), c({}, ImageValues::decibel);
  const ImagePlane first = a.normalise(amplitude, kBeams, kBins);
  const ImagePlane second = b.normalise(power, kBeams, kBins), third = c.normalise(decibel, kBeams, kBins);
  for (std::size_t i = 0; i < first.values.size(); ++i) {
    EXPECT_NEAR(first.values[i], second.values[i], 1e-5F);
    EXPECT_NEAR(first.values[i], third.values[i], 1e-5F);
  }
}

TEST(GainBackground, WhatStandsStillBecomesBackground) {
  std::vector<double> values = striped();
  values[5 * kBins + 20] *= 10.0;
  GainBackground background({100.0, 1.5}, ImageValues::amplitude);
  float first = background.normalise(values, kBeams, kBins).at(5, 20), last = first;
  for (int ping = 0; ping < 100; ++ping) last = background.normalise(values, kBeams, kBins).at(5, 20);
  EXPECT_GT(first, 40.0F);
  EXPECT_LT(last, 2.0F);  // Within the doubt of 3 sqrt(step) nepers.
}

TEST(GainBackground, WhatPassesThroughIsNotLearnt) {
  GainBackground background({100.0, 1.5}, ImageValues::amplitude);
  for (int ping = 0; ping < 100; ++ping) background.normalise(striped(), kBeams, kBins);
  std::vector<double> values = striped();
  values[5 * kBins + 20] *= 10.0;
  const float first = background.normalise(values, kBeams, kBins).at(5, 20);
  for (int ping = 0; ping < 10; ++ping) background.normalise(values, kBeams, kBins);
  // Ten pings pull by 10 x 1.5 / 100 nepers at most, less than the doubt.
  EXPECT_NEAR(background.normalise(values, kBeams, kBins).at(5, 20), first, 0.02F * first);
}

TEST(GainBackground, WithoutMemoryNothingStandsStill) {
  std::vector<double> values = striped();
  values[5 * kBins + 20] *= 10.0;
  GainBackground background({0.0, 1.5}, ImageValues::amplitude);
  const float first = background.normalise(values, kBeams, kBins).at(5, 20);
  for (int ping = 0; ping < 50; ++ping) background.normalise(values, kBeams, kBins);
  EXPECT_EQ(background.normalise(values, kBeams, kBins).at(5, 20), first);
}

TEST(GainBackground, ADarkImageIsFlat) {
  GainBackground background({}, ImageValues::amplitude);
  const std::vector<double> dark(kBeams * kBins, 0.0);
  for (const float value : background.normalise(dark, kBeams, kBins).values) EXPECT_NEAR(value, 1.0F, 1e-5F);
}

TEST(GainBackground, RefusesBadParameters) {
  EXPECT_THROW(GainBackground({0.5, 1.5}, ImageValues::power), std::invalid_argument);
  EXPECT_THROW(GainBackground({100.0, 0.0}, ImageValues::power), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
