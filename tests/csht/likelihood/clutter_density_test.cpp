#include "csht/likelihood/clutter_density.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::csht {
namespace {

// The same Bayes factor as a plain sum over rates: the gamma density by the midpoint rule.
double integrated_factor(int count, double expected, double shape) {
  double sum = 0.0;
  constexpr int kSteps = 400000;
  constexpr double kMost = 40.0;  // Beyond, the density is below e^-20.
  const double step = kMost / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    const double rate = (k + 0.5) * step;
    const double prior = std::exp(shape * std::log(shape) - std::lgamma(shape) +
                                  (shape - 1.0) * std::log(rate) - shape * rate);
    sum += step * prior * std::exp(count * std::log(rate) - expected * (rate - 1.0));
  }
  return std::log(sum);
}

TEST(ClutterDensity, FactorIsThatOfTheIntegralOverRates) {
  EXPECT_NEAR(log_excess_factor(3.0, 2.0, 2.0), integrated_factor(3, 2.0, 2.0), 1e-4);
  EXPECT_NEAR(log_excess_factor(0.0, 1.5, 2.0), integrated_factor(0, 1.5, 2.0), 1e-4);
}

TEST(ClutterDensity, WhatReturnsNoMoreThanTheBackgroundHasNoExcess) {
  EXPECT_EQ(excess_density(2.0, 2.0, {}), 0.0);
  EXPECT_EQ(excess_density(0.0, 5.0, {}), 0.0);
}

// Sixty returns where one was to be expected leave no doubt: the excess is the slab's (60 + a) / (1 + a) - 1.
TEST(ClutterDensity, ManyReturnsAreBelieved) {
  EXPECT_NEAR(excess_density(60.0, 1.0, {0.05, 0.5}), 60.5 / 1.5 - 1.0, 1e-6);
}

TEST(ClutterDensity, AFewReturnsAreBelievedByTheirOdds) {
  const ExcessPrior prior{0.05, 0.5};
  const double odds = 0.05 / 0.95 * std::exp(log_excess_factor(3.0, 1.0, 0.5));
  EXPECT_NEAR(excess_density(3.0, 1.0, prior), odds / (1.0 + odds) * (3.5 / 1.5 - 1.0), 1e-12);
}

}  // namespace
}  // namespace lookout::csht
