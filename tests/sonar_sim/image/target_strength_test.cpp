#include "sonar_sim/image/target_strength.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace lookout::sonar_sim {
namespace {

constexpr int kPings = 100'000;

std::vector<double> powers(int swerling, double dwell) {
  TargetStrength strength({swerling, dwell}, core::Random(1000 + static_cast<std::uint64_t>(swerling)));
  std::vector<double> all;
  for (int ping = 0; ping < kPings; ++ping) {
    const double amplitude = strength.amplitude(7, 0.1 * ping);
    all.push_back(amplitude * amplitude);
  }
  return all;
}

TEST(TargetStrength, HasTheLawOfItsCase) {
  struct Law {
    int swerling;
    double variance;  // Of the power over its squared mean: 1 / k of a gamma law of shape k.
    double below_half;
  };
  // P(power < 1/2): 1 - exp(-.5), and 1 - 2 exp(-1) of four degrees of freedom.
  for (const Law& law : {Law{2, 1.0, 0.39347}, Law{4, 0.5, 0.26424}}) {
    double sum = 0.0, squares = 0.0, below = 0.0;
    for (const double power : powers(law.swerling, 1.0))
      sum += power, squares += power * power, below += power < 0.5 ? 1.0 : 0.0;
    const double mean = sum / kPings;
    EXPECT_NEAR(mean, 1.0, 0.02);
    EXPECT_NEAR(squares / kPings - mean * mean, law.variance, 0.05);
    EXPECT_NEAR(below / kPings, law.below_half, 0.01);
  }
}

TEST(TargetStrength, HoldsADrawForADwellInCasesOneAndThree) {
  for (const int swerling : {1, 3}) {
    const auto all = powers(swerling, 1.0);
    int changes = 0;
    for (std::size_t i = 1; i < 1000; ++i) changes += all[i] != all[i - 1] ? 1 : 0;
    EXPECT_EQ(changes, 99);  // A hundred seconds.
  }
  const auto fast = powers(2, 1.0);
  EXPECT_NE(fast[0], fast[1]);
  EXPECT_EQ(powers(0, 1.0)[5], 1.0);
}

}  // namespace
}  // namespace lookout::sonar_sim
