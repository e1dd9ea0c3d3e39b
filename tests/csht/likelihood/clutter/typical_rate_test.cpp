#include "csht/likelihood/clutter/typical_rate.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace lookout::csht {
namespace {

// `rate` returns a scan, uniform over the fan, and `dense` more in its second quarter along the range.
TypicalRate taught(int scans, double rate, double dense) {
  core::Random random(5);
  TypicalRate typical;
  typical.begin(90);
  for (int k = 0; k < scans; ++k) {
    for (int i = 0; i < 2 * static_cast<int>(rate); ++i)
      if (random.bernoulli(0.5)) typical.take(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0), 1.0F);
    for (int i = 0; i < static_cast<int>(dense); ++i)
      typical.take(random.uniform(0.0, 1.0), random.uniform(0.25, 0.5), 1.0F);
  }
  typical.end(scans);
  return typical;
}

// Clearly more is 1.3 times as much; 128 blocks say 9 a scan within 3 standard errors, 10 % of 60 scans.
TEST(TypicalRate, IsTheRateOfAnEvenFan) {
  EXPECT_NEAR(taught(60, 9.0, 0.0).at_most(1e3), 1.3 * 9.0, 1.3 * 0.9);
}

TEST(TypicalRate, ALowerRateIsRaisedToIt) {
  const TypicalRate typical = taught(60, 9.0, 0.0);
  EXPECT_NEAR(typical.at_least(1.0), 9.0, 0.9);
  EXPECT_EQ(typical.at_least(20.0), 20.0);
  EXPECT_EQ(TypicalRate().at_least(1.0), 1.0);  // nothing is known yet
}

// Four scans leave most blocks empty, 36 returns for 128: 17 % are three standard errors, sqrt(e^m - 1) /
// sqrt(128).
TEST(TypicalRate, IsKnownAfterAFewScans) {
  EXPECT_NEAR(taught(4, 9.0, 0.0).at_most(1e3), 1.3 * 9.0, 1.3 * 9.0 * 0.5);
}

// A quarter of the fan has six times as many returns as all the rest: the mean would be 63.
TEST(TypicalRate, DensePlacesDoNotCount) {
  EXPECT_LT(taught(60, 9.0, 54.0).at_most(1e3), 1.3 * 12.0);
}

TEST(TypicalRate, LeavesARateThatFitsAlone) {
  EXPECT_EQ(taught(60, 9.0, 0.0).at_most(9.0), 9.0);
  EXPECT_EQ(TypicalRate().at_most(7.0), 7.0);  // Nothing is known.
}

}  // namespace
}  // namespace lookout::csht
