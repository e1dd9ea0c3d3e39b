#include "tracking/detection/peak_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace lookout::tracking {
namespace {

constexpr int kPings = 30, kPeaks = 3000;

/// Threshold that one peak a ping reaches, after pings of peaks with the given quantile function.
template <class Draw>
double threshold_of(Draw draw, int targets = 0) {
  PeakLaw law(1e9);  // Nothing fades.
  std::mt19937 random(5);
  double threshold = 0.0;
  for (int ping = 0; ping < kPings; ++ping) {
    law.begin_ping();
    for (int i = 0; i < kPeaks; ++i) law.add(draw(random));
    for (int i = 0; i < targets; ++i) law.add(100.0);
    threshold = law.threshold(1.0);
  }
  return threshold;
}

double exponential(std::mt19937& random) {
  return std::exponential_distribution<double>(1.0)(random);
}

// One in 3000 exponential numbers is above ln 3000 = 8.006. 30 of them were seen above it: the logarithm of
// their rate errs by 1 / sqrt(30) = 0.18 or, with the law's help, less; 3 of these.
TEST(PeakLaw, FindsTheTailOfAnExponentialLaw) {
  EXPECT_NEAR(threshold_of(exponential), std::log(3000.0), 0.5);
}

// P(z > t) = exp(-2 sqrt(t)) : one in 3000 above (ln 3000 / 2)^2 = 16.03.
TEST(PeakLaw, FindsAStretchedTail) {
  const double threshold = threshold_of([](std::mt19937& random) {
    const double root = 0.5 * exponential(random);
    return root * root;
  });
  EXPECT_NEAR(std::sqrt(threshold), 0.5 * std::log(3000.0), 0.3);
}

TEST(PeakLaw, TargetsAboveTheThresholdDoNotRaiseIt) {
  const double without = threshold_of(exponential);
  EXPECT_NEAR(threshold_of(exponential, 5), without, 0.02 * without);
}

TEST(PeakLaw, FewPeaksPromiseLess) {
  std::mt19937 random(9);
  PeakLaw few(100.0);
  few.begin_ping();
  for (int i = 0; i < 100; ++i) few.add(exponential(random));
  EXPECT_GT(few.threshold(0.1), std::log(1000.0) - 2.0);
  EXPECT_TRUE(std::isfinite(few.threshold(0.1)));
}

TEST(PeakLaw, ForgetsAnotherSea) {
  std::mt19937 random(3);
  PeakLaw law(5.0);
  const auto pings = [&](double scale) {
    double threshold = 0.0;
    for (int ping = 0; ping < 40; ++ping) {
      law.begin_ping();
      for (int i = 0; i < kPeaks; ++i) law.add(scale * exponential(random));
      threshold = law.threshold(1.0);
    }
    return threshold;
  };
  const double first = pings(1.0);
  EXPECT_NEAR(pings(3.0) / first, 3.0, 0.5);
}

TEST(PeakLaw, WithoutPeaksNothingIsAbove) {
  PeakLaw law(10.0);
  EXPECT_TRUE(std::isinf(law.threshold(1.0)));
  EXPECT_THROW(PeakLaw(0.5), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
