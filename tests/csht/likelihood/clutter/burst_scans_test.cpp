#include "csht/likelihood/clutter/burst_scans.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.hpp"

namespace lookout::csht {
namespace {

constexpr double kUsual = 9.0;  // Returns of a scan.

// Ninety beams that return by .1 each; what is believed of the last of `scans` scans.
Burst watch(BurstScans& bursts, int scans, core::Random& random, double probability = 0.1) {
  Burst burst;
  for (int k = 0; k < scans; ++k) {
    int count = 0;
    for (int beam = 0; beam < 90; ++beam) count += random.bernoulli(probability) ? 1 : 0;
    burst = bursts.take(count, kUsual);
  }
  return burst;
}

TEST(BurstScans, ChanceMakesNone) {
  BurstScans bursts;
  core::Random random(3);
  double most = 0.0;
  for (int k = 0; k < 1000; ++k) most = std::max(most, watch(bursts, 1, random).probability);
  EXPECT_LT(most, 0.5);
  EXPECT_LT(bursts.share(), 0.01);
}

// 85 returns where 9 are usual: 9.4 times as many, 8.4 more.
TEST(BurstScans, ABurstIsKnownByItsReturns) {
  BurstScans bursts;
  core::Random random(3);
  watch(bursts, 60, random);
  const Burst burst = bursts.take(85.0, kUsual);
  EXPECT_GT(burst.probability, 0.99);
  EXPECT_NEAR(burst.excess, 8.4, 1.0);
  EXPECT_LT(watch(bursts, 1, random).probability, 0.1);  // The next scan is as usual.
}

TEST(BurstScans, AtFirstNothingIsUnusual) {
  BurstScans bursts;
  for (int k = 0; k < 10; ++k) EXPECT_EQ(bursts.take(85.0, kUsual).excess, 0.0);
}

// A figure that is told too low makes no burst of every scan: what scans have had counts.
TEST(BurstScans, MoreThanTheFiguresTellIsUsualWhereAllScansHaveIt) {
  BurstScans bursts;
  core::Random random(3);
  EXPECT_LT(watch(bursts, 40, random, 0.5).probability, 0.01);
}

// From 9 returns a scan to 54. While that is new it is a burst; once most scans have it, it is usual and
// teaches.
TEST(BurstScans, WhatLastsBecomesUsual) {
  BurstScans bursts;
  core::Random random(3);
  watch(bursts, 60, random);
  EXPECT_GT(watch(bursts, 5, random, 0.6).probability, 0.9);
  const Burst later = watch(bursts, 60, random, 0.6);
  EXPECT_EQ(later.probability, 0.0);
  EXPECT_LT(watch(bursts, 100, random, 0.6).excess, 0.1);
}

}  // namespace
}  // namespace lookout::csht
