#include "csht/likelihood/clutter/clutter_density.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::csht {
namespace {

// The same Bayes factor as a plain sum over rates: the gamma density by the midpoint rule.
double integrated_factor(int count, double expected, double shape, double mean) {
  double sum = 0.0;
  const double scale = shape / mean;
  constexpr int kSteps = 400000;
  constexpr double kMost = 40.0;  // Beyond, the density is below e^-20.
  const double step = kMost / kSteps;
  for (int k = 0; k < kSteps; ++k) {
    const double rate = (k + 0.5) * step;
    const double prior = std::exp(shape * std::log(scale) - std::lgamma(shape) +
                                  (shape - 1.0) * std::log(rate) - scale * rate);
    sum += step * prior * std::exp(count * std::log(rate) - expected * (rate - 1.0));
  }
  return std::log(sum);
}

TEST(ClutterDensity, FactorIsThatOfTheIntegralOverRates) {
  EXPECT_NEAR(log_excess_factor(3.0, 2.0, {0.1, 2.0}), integrated_factor(3, 2.0, 2.0, 1.0), 1e-4);
  EXPECT_NEAR(log_excess_factor(0.0, 1.5, {0.1, 2.0}), integrated_factor(0, 1.5, 2.0, 1.0), 1e-4);
  EXPECT_NEAR(log_excess_factor(3.0, 0.5, {0.1, 2.0, 4.0}), integrated_factor(3, 0.5, 2.0, 4.0), 1e-4);
}

TEST(ClutterDensity, WhatReturnsNoMoreThanTheBackgroundHasNoExcess) {
  EXPECT_EQ(excess(2.0, 2.0, {}).density(), 0.0);
  EXPECT_EQ(excess(0.0, 5.0, {}).density(), 0.0);
}

// Sixty returns where one was to be expected leave no doubt: the excess is the slab's (60 + a) / (1 + a) - 1.
TEST(ClutterDensity, ManyReturnsAreBelieved) {
  EXPECT_NEAR(excess(60.0, 1.0, {0.05, 0.5}).density(), 60.5 / 1.5 - 1.0, 1e-6);
}

TEST(ClutterDensity, AFewReturnsAreBelievedByTheirOdds) {
  const ExcessPrior prior{0.05, 0.5};
  const double odds = 0.05 / 0.95 * std::exp(log_excess_factor(3.0, 1.0, prior));
  EXPECT_NEAR(excess(3.0, 1.0, prior).density(), odds / (1.0 + odds) * (3.5 / 1.5 - 1.0), 1e-12);
}

// Where dense places return forty times as much, one return where .05 was to be expected is suspect.
TEST(ClutterDensity, TheMeanOfDensePlacesMakesAFewReturnsSuspect) {
  EXPECT_GT(excess(1.0, 0.05, {0.5, 0.5, 40.0}).density(), 4.0 * excess(1.0, 0.05, {0.5, 0.5}).density());
}

}  // namespace
}  // namespace lookout::csht
