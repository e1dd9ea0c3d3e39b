#include "tracking/track_before_detect/axis_integrals.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

/// Gauss-Legendre quadrature with five nodes on each of 400 panels, in extended precision.
template <typename Function>
long double quadrature(Function f, long double low, long double high) {
  constexpr std::array<long double, 5> kNodes{
      0.0L, 0.538469310105683091036314420700208805L, -0.538469310105683091036314420700208805L,
      0.906179845938663992797626878299392965L, -0.906179845938663992797626878299392965L};
  constexpr std::array<long double, 5> kWeights{
      0.568888888888888888888888888888888889L, 0.478628670499366468041291514835638193L,
      0.478628670499366468041291514835638193L, 0.236926885056189087514264040719917363L,
      0.236926885056189087514264040719917363L};
  constexpr int kPanels = 400;
  long double sum = 0.0L;
  const long double half = (high - low) / (2 * kPanels);
  for (int i = 0; i < kPanels; ++i)
    for (std::size_t j = 0; j < kNodes.size(); ++j)
      sum += kWeights[j] * half * f(low + half * (2 * i + 1 + kNodes[j]));
  return sum;
}

long double normal(long double x, long double mean, long double variance) {
  return std::exp(-(x - mean) * (x - mean) / (2 * variance)) /
         std::sqrt(2 * std::numbers::pi_v<long double> * variance);
}

TEST(AxisIntegrals, AgreeWithQuadratureToTwelveDigits) {
  for (const double variance : {0.5, 1.0, 7.6, 35.8, 400.0})
    for (const double mean : {-3.2, 0.0, 5.5, 10.0, 33.3})
      for (int cell = 0; cell < 20; ++cell) {
        const CellIntegrals got = integrate_cell(mean, variance, cell, cell + 1);
        const auto density = [&](long double x) { return normal(x, mean, variance); };
        EXPECT_NEAR(got.probability, static_cast<double>(quadrature(density, cell, cell + 1)), 1e-12);
        const auto first = [&](long double x) { return (x - mean) * density(x); };
        EXPECT_NEAR(got.first, static_cast<double>(quadrature(first, cell, cell + 1)), 1e-12);
        const auto second = [&](long double x) { return (x - mean) * (x - mean) * density(x); };
        EXPECT_NEAR(got.second, static_cast<double>(quadrature(second, cell, cell + 1)), 1e-12);
      }
}

TEST(AxisIntegrals, TailsKeepTheirRelativeAccuracy) {
  const auto density = [](long double x) { return normal(x, 0.0L, 1.0L); };
  const double expected = static_cast<double>(quadrature(density, 20.0L, 21.0L));
  EXPECT_NEAR(integrate_cell(0.0, 1.0, 20.0, 21.0).probability / expected, 1.0, 1e-12);
  EXPECT_NEAR(integrate_cell(0.0, 1.0, -21.0, -20.0).probability / expected, 1.0, 1e-12);
}

TEST(AxisIntegrals, FarTailsGoToZeroAndNeverBelow) {
  for (int cell = 30; cell < 200; ++cell) {
    const CellIntegrals far = integrate_cell(0.0, 1.0, cell, cell + 1);
    EXPECT_GE(far.probability, 0.0);
    EXPECT_GE(far.second, 0.0);
    EXPECT_TRUE(std::isfinite(far.first));
  }
  EXPECT_EQ(integrate_cell(0.0, 1.0, 100.0, 101.0).probability, 0.0);
}

TEST(AxisIntegrals, SumsOverAWideAxisAreTheMomentsOfTheDensity) {
  AxisIntegrals axis;
  axis.compute(50.0, 9.0, 0, 100);  // the mean on a corner between cells, the edges 16 sigma away
  EXPECT_NEAR(axis.sum().probability, 1.0, 1e-12);
  EXPECT_NEAR(axis.sum().first, 0.0, 1e-12);
  EXPECT_NEAR(axis.sum().second, 9.0, 1e-11);
  EXPECT_DOUBLE_EQ(axis.probability()[49], axis.probability()[50]);
}

TEST(AxisIntegrals, OneByOneAgreesWithTheAxis) {
  AxisIntegrals axis;
  axis.compute(7.3, 2.5, 4, 6);
  for (int i = 0; i < 6; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_DOUBLE_EQ(axis.probability()[at], cell_probability(7.3, 2.5, 4 + i, 5 + i));
    EXPECT_NEAR(axis.first()[at], cell_first_moment(7.3, 2.5, 4 + i, 5 + i), 1e-15);
    EXPECT_NEAR(axis.second()[at], cell_second_moment(7.3, 2.5, 4 + i, 5 + i), 1e-15);
  }
}

}  // namespace
}  // namespace lookout::tracking
