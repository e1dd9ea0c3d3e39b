#include "tracking/baselines/gaussian/undetected_intensity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace lookout::tracking {
namespace {

constexpr double kArea = 1000.0;

TEST(UndetectedIntensity, TargetsStayForTheirShareOfACrossing) {
  PopulationParams params;
  params.stay = 2.0;
  const UndetectedIntensity undetected(params, {});
  EXPECT_NEAR(undetected.survival(0.5), std::exp(-0.5 / (2.0 * 150.0 / 3.0)), 1e-12);
}

TEST(UndetectedIntensity, UnseenTheyFillUpToTheirNumber) {
  PopulationParams params;
  params.settling_scans = 0.0;
  UndetectedIntensity undetected(params, {});
  for (int k = 0; k < 4000; ++k) undetected.predict(0.5, kArea);
  EXPECT_NEAR(undetected.density() * kArea, params.expected_targets, 1e-6);
}

TEST(UndetectedIntensity, SettlesInTheFirstScans) {
  PopulationParams params;
  params.stay = 1e9;  // no other births
  params.settling_scans = 4.0;
  params.settling_share = 0.5;
  UndetectedIntensity undetected(params, {});
  for (int k = 0; k < 10; ++k) undetected.predict(k == 0 ? 0.0 : 0.5, kArea);
  EXPECT_NEAR(undetected.density() * kArea, 4.0 * 0.5 * params.expected_targets, 1e-6);
}

TEST(UndetectedIntensity, WhatIsDetectedIsGone) {
  UndetectedIntensity undetected({}, {});
  undetected.predict(0.0, kArea);
  const double before = undetected.density();
  undetected.miss(0.75);
  EXPECT_DOUBLE_EQ(undetected.density(), 0.25 * before);
}

TEST(UndetectedIntensity, RefusesParametersOutOfRange) {
  for (const PopulationParams& params :
       {PopulationParams{.expected_targets = 0.0}, PopulationParams{.stay = -1.0},
        PopulationParams{.settling_scans = -1.0}, PopulationParams{.settling_share = -1.0}})
    EXPECT_THROW(UndetectedIntensity(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
