#include "tracking/track_before_detect/images/tail_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

std::vector<double> exponential(int size, std::uint64_t seed) {
  core::Random random(seed);
  std::vector<double> values;
  for (int i = 0; i < size; ++i) values.push_back(-std::log(1.0 - random.uniform(0.0, 1.0)));
  std::sort(values.begin(), values.end());
  return values;
}

TEST(TailLaw, AnExponentialTailGoesOnBeyondTheSample) {
  TailLaw law;
  std::vector<std::vector<double>> frames;
  for (std::uint64_t k = 0; k < 10; ++k) frames.push_back(exponential(2000, 1000 + k));
  for (const auto& frame : frames) law.learn(frame);
  EXPECT_NEAR(law.log_probability(15.0), -15.0, 1.5);  // ln exp(-15), a tenth of the slope's error
  EXPECT_NEAR(law.value_of(std::exp(-10.0)), 10.0, 1.0);
}

TEST(TailLaw, InTheBulkItIsTheRank) {
  std::vector<double> values;
  for (int i = 0; i < 999; ++i) values.push_back(i);
  TailLaw law;
  law.learn(values);
  EXPECT_NEAR(law.log_probability(499.0), std::log(0.5), 0.01);
}

TEST(TailLaw, FewBlocksWithTargetsDoNotChangeTheSlope) {
  std::vector<double> plain = exponential(2000, 1020), bright = plain;
  for (std::size_t i = 0; i < 5; ++i) bright[bright.size() - 1 - i] = 100.0;
  TailLaw one, other;
  one.learn(plain);
  other.learn(bright);
  EXPECT_DOUBLE_EQ(one.log_probability(12.0), other.log_probability(12.0));
}

TEST(TailLaw, WithoutBlocksNothingIsImprobable) {
  EXPECT_EQ(TailLaw().log_probability(1e9), 0.0);
}

}  // namespace
}  // namespace lookout::tracking
