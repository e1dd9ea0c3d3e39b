#include "sonar_sim/sea/fluctuation.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/sea_ping.hpp"

namespace lookout::sonar_sim {
namespace {

/// The powers of many returns, one a ping.
std::vector<double> powers_of(const FluctuationPlan& plan, Source source) {
  const Fluctuation fluctuation(plan);
  core::Random random(1);
  std::vector<double> powers;
  for (int k = 0; k < kPings; ++k) {
    std::vector<BeamReturn> heard{{45, {0.0, 60.0, 1.0}, source}};
    fluctuation.mark(heard, random);
    powers.push_back(heard[0].measured.intensity * heard[0].measured.intensity);
  }
  return powers;
}

double share_above(const std::vector<double>& powers, double limit) {
  double above = 0.0;
  for (const double power : powers) above += power > limit ? 1.0 : 0.0;
  return above / static_cast<double>(powers.size());
}

double mean_of(const std::vector<double>& powers) {
  double sum = 0.0;
  for (const double power : powers) sum += power;
  return sum / static_cast<double>(powers.size());
}

TEST(Fluctuation, KLawOfShapeOneHalfIsExponentialInAmplitude) {
  // K_1/2(z) = sqrt(pi / (2 z)) exp(-z), so that P(power > x) = exp(-sqrt(2 x)).
  for (const double x : {0.1, 1.0, 7.0}) EXPECT_NEAR(k_survival(0.5, x), std::exp(-std::sqrt(2.0 * x)), 1e-9);
  EXPECT_NEAR(k_survival(50.0, 2.0), std::exp(-2.0), 0.01);  // near Rayleigh
  EXPECT_EQ(k_survival(50.0, 1e-30), 1.0);
}

TEST(Fluctuation, ClutterHasMeanPowerOneAndTheTailOfItsLaw) {
  const auto powers = powers_of({1, 13.0, 1.5, 0.0}, Source::background);
  // The second moment of the power is 2 (1 + 1 / nu): variance 7 / 3 for nu = 1.5.
  EXPECT_NEAR(mean_of(powers), 1.0, mean_tolerance(std::sqrt(7.0 / 3.0), kPings));
  for (const double x : {0.1, 1.0, 4.0})
    EXPECT_NEAR(share_above(powers, x), k_survival(1.5, x), rate_tolerance(k_survival(1.5, x), kPings)) << x;
}

TEST(Fluctuation, EchoesFollowTheirCase) {
  for (const int swerling : {1, 2, 3, 4}) {
    const auto powers = powers_of({swerling, 10.0, 1.5, 0.0}, Source::target);  // mean power 10
    for (const double x : {0.2, 1.0, 2.5}) {
      const double expected = swerling_survival(swerling, x);
      EXPECT_NEAR(share_above(powers, 10.0 * x), expected, rate_tolerance(expected, kPings)) << swerling;
    }
  }
  const auto steady = powers_of({0, 10.0, 1.5, 0.0}, Source::target);
  EXPECT_NEAR(*std::max_element(steady.begin(), steady.end()), 10.0, 1e-9);
}

TEST(Fluctuation, ReportedReturnsAreTheLawAboveTheThreshold) {
  const double threshold = 1.5, least = threshold * threshold;
  const auto clutter = powers_of({1, 10.0, 1.5, threshold}, Source::clutter);
  EXPECT_GE(*std::min_element(clutter.begin(), clutter.end()), least * (1.0 - 1e-12));
  const double tail = k_survival(1.5, 6.0) / k_survival(1.5, least);
  EXPECT_NEAR(share_above(clutter, 6.0), tail, rate_tolerance(tail, kPings));
  const auto echoes = powers_of({3, 6.0, 1.5, threshold}, Source::standing);
  const double mean = std::pow(10.0, 0.6);
  const double echo_tail = swerling_survival(3, 6.0 / mean) / swerling_survival(3, least / mean);
  EXPECT_NEAR(share_above(echoes, 6.0), echo_tail, rate_tolerance(echo_tail, kPings));
}

TEST(Fluctuation, OddCasesShareOneDrawAmongTheEchoesOfAThing) {
  core::Random random(2);
  for (const int swerling : {1, 2, 3, 4}) {
    std::vector<BeamReturn> heard{{45, {0.0, 60.0, 1.0}, Source::target, 0},
                                  {46, {0.0, 60.0, 1.0}, Source::spill, 0},
                                  {47, {0.0, 60.0, 1.0}, Source::target, 1}};
    heard[1].loss_db = 20.0;  // a tenth of the amplitude
    Fluctuation({swerling, 10.0, 1.5, 0.0}).mark(heard, random);
    const bool shared = std::abs(heard[1].measured.intensity - 0.1 * heard[0].measured.intensity) < 1e-9;
    EXPECT_EQ(shared, swerling % 2 == 1) << swerling;
    EXPECT_NE(heard[2].measured.intensity, heard[0].measured.intensity);
  }
}

TEST(Fluctuation, RefusesWhatItCannotDraw) {
  EXPECT_THROW(Fluctuation({5, 10.0, 1.5, 0.0}), std::invalid_argument);
  EXPECT_THROW(Fluctuation({1, 10.0, 0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(Fluctuation({1, 10.0, 1.5, -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::sonar_sim
