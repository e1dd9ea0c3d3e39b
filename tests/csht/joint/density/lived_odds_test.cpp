#include "csht/joint/density/lived_odds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lookout::csht {
namespace {

TEST(LivedOdds, WithoutScansTheyAreThoseBefore) {
  EXPECT_DOUBLE_EQ(lived_odds(-7.0, {}, {}), -7.0);
}

// Who cannot vanish forgets nothing: the evidence adds up.
TEST(LivedOdds, EvidenceOfAnImmortalAddsUp) {
  EXPECT_NEAR(lived_odds(-7.0, std::vector{1.0, 2.0, 3.0}, std::vector{1.0, 1.0, 1.0}), -1.0, 1e-9);
}

// Two scans by hand: 1/2 after the first, .9 of it before the second, odds .45/.55 times e^2 after it.
TEST(LivedOdds, IsTheBernoulliFilter) {
  EXPECT_NEAR(lived_odds(-3.0, std::vector{2.0, 3.0}, std::vector{0.9, 0.1}), std::log(0.45 / 0.55) + 2.0,
              1e-12);
}

// Fast scans add up to thousands of nats: neither certainty is beyond the numbers.
TEST(LivedOdds, StayFiniteHoweverSureTheyAre) {
  const std::vector<double> immortal(500, 1.0), mortal(500, 0.999);
  EXPECT_NEAR(lived_odds(-10.0, std::vector<double>(500, 5.0), immortal), 2490.0, 1e-6);
  EXPECT_NEAR(lived_odds(-10.0, std::vector<double>(500, -5.0), mortal), -2510.0 + 499.0 * std::log(0.999),
              0.01);
}

// However much a target gained, before a scan it has survived with no more than the probability to do so.
TEST(LivedOdds, SaturateAtTheProbabilityToVanish) {
  const std::vector<double> survival(40, 0.999);
  std::vector<double> gains(40, 4.0);
  const double odds = lived_odds(-10.0, gains, survival);
  EXPECT_NEAR(odds, std::log(0.999 / 0.001) + 4.0, 0.1);
  for (std::size_t age = 20; age < 40; ++age) gains[age] = 3.0;  // Twenty nats less, long ago.
  EXPECT_NEAR(lived_odds(-10.0, gains, survival), odds, 0.1);
}

}  // namespace
}  // namespace lookout::csht
