#include "csht/likelihood/sensor_likelihood.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/random.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

constexpr double kMiss = 0.3, kFalse = 0.1, kSigma = 2.0;
const SensorFigures kFigures{kMiss, kFalse, 4.0, kSigma, 0.02};

ScanTable table_of(std::vector<core::SonarReturn> returns, ClutterModel clutter,
                   const core::Pose2& pose = {}) {
  ScanTable table;
  fill_scan_table(posed_scan(std::move(returns), 0, pose), table);
  set_figures(kFigures, {.clutter = clutter}, table);
  return table;
}

double gaussian(double offset) {
  return std::exp(-0.5 * offset * offset / (kSigma * kSigma)) / (kSigma * std::sqrt(2 * std::numbers::pi));
}

// Beam 45 is centred half a degree to starboard.
Eigen::Vector2d in_beam_45(double range) {
  return core::from_polar(range, core::radians(0.5));
}

TEST(SensorLikelihood, ExclusiveBeamIsTheFormulaOfTheLiteralSonar) {
  const auto table = table_of({{core::radians(0.5), 80.0, 1}}, ClutterModel::exclusive_beam);
  const auto silent = table_of({}, ClutterModel::exclusive_beam);
  EXPECT_NEAR(log_ratio(table, nullptr, in_beam_45(81.0)),
              std::log((1 - kMiss) * gaussian(1.0) * 150.0 / kFalse + std::exp(-8.0)), 1e-5);
  EXPECT_NEAR(log_ratio(table, nullptr, in_beam_45(40.0)), -8.0, 1e-5);  // The floor.
  EXPECT_NEAR(log_ratio(silent, nullptr, in_beam_45(81.0)), std::log(kMiss / (1 - kFalse)), 1e-5);
  EXPECT_EQ(log_ratio(table, nullptr, in_beam_45(151.0)), 0.0);
  EXPECT_EQ(log_ratio(table, nullptr, {-50.0, 0.0}), 0.0);
}

TEST(SensorLikelihood, EdgesAreAMixtureOfBothBeams) {
  const auto table = table_of({{core::radians(0.5), 80.0, 1}}, ClutterModel::exclusive_beam);
  const double reported = std::exp(log_ratio(table, nullptr, in_beam_45(80.0)));
  const double silence = kMiss / (1 - kFalse);
  const auto at = [&](double deg) {
    return std::exp(log_ratio(table, nullptr, core::from_polar(80.0, core::radians(deg))));
  };
  EXPECT_NEAR(at(1.0), 0.5 * (reported + silence), 1e-4);         // On the edge.
  EXPECT_NEAR(at(1.05), 0.25 * reported + 0.75 * silence, 1e-3);  // Half way out of the soft part.
  EXPECT_NEAR(at(1.11), silence, 1e-6);
}

// With echoes that range takes, P_M is .3 + .4 (r / 150)^2; a tenth of the returns have three times the
// error.
TEST(SensorLikelihood, RangeTakesEchoesAndErrorsHaveTails) {
  SensorFigures figures = kFigures;
  figures.range_loss = 0.4;
  figures.tail_share = 0.1;
  auto table = table_of({{core::radians(0.5), 80.0, 1}}, ClutterModel::exclusive_beam);
  auto silent = table_of({}, ClutterModel::exclusive_beam);
  for (ScanTable* one : {&table, &silent}) set_figures(figures, {}, *one);
  const double range = 88.0, miss = 0.3 + 0.4 * range * range / (150.0 * 150.0);
  const double density = 0.9 * gaussian(8.0) + 0.1 * gaussian(8.0 / 3.0) / 3.0;
  EXPECT_NEAR(log_ratio(table, nullptr, in_beam_45(range)),
              std::log((1 - miss) * density * 150.0 / kFalse + std::exp(-8.0)), 1e-5);
  EXPECT_NEAR(log_ratio(silent, nullptr, in_beam_45(range)), std::log(miss / (1 - kFalse)), 1e-5);
  const std::array north{in_beam_45(range).x()}, east{in_beam_45(range).y()}, still{0.0};
  for (const ScanTable* one : {&table, &silent}) {
    std::array fast{0.0};
    add_log_ratio(*one, nullptr, {north, east, still, still}, 0.0, {}, fast);
    EXPECT_NEAR(fast[0], log_ratio(*one, nullptr, in_beam_45(range)), 1e-4);
  }
}

// Under clutter alone a likelihood ratio averages 1 by construction; the return's range is integrated by the
// midpoint rule. The floor adds what it is: P_F e^-8.
double mean_under_clutter(ClutterModel clutter, const BeamMask* mask = nullptr, double at = 80.0) {
  const int steps = 15000;
  double mean = (1 - kFalse) * std::exp(log_ratio(table_of({}, clutter), mask, in_beam_45(at)));
  for (int i = 0; i < steps; ++i) {
    const double range = 150.0 * (i + 0.5) / steps;
    const auto table = table_of({{core::radians(0.5), range, 1}}, clutter);
    mean += kFalse / steps * std::exp(log_ratio(table, mask, in_beam_45(at)));
  }
  return mean;
}

TEST(SensorLikelihood, AveragesOneUnderClutter) {
  EXPECT_NEAR(mean_under_clutter(ClutterModel::exclusive_beam), 1.0 + kFalse * std::exp(-8.0), 1e-5);
  EXPECT_NEAR(mean_under_clutter(ClutterModel::shared_beam), 1.0, 1e-5);
}

// At either end of the range gate too: what a silence gains there is what returns lose.
TEST(SensorLikelihood, AveragesOneWhereNoiseTakesReturnsOutOfTheGate) {
  for (const double at : {149.9, 148.0, 1.0}) {
    EXPECT_NEAR(mean_under_clutter(ClutterModel::exclusive_beam, nullptr, at), 1.0 + kFalse * std::exp(-8.0),
                1e-4);
    EXPECT_NEAR(mean_under_clutter(ClutterModel::shared_beam, nullptr, at), 1.0, 1e-4);
  }
}

TEST(SensorLikelihood, ASilenceAtTheEndOfTheRangeIsHalfAMiss) {
  const auto silent = table_of({}, ClutterModel::exclusive_beam);
  EXPECT_NEAR(std::exp(log_ratio(silent, nullptr, in_beam_45(150.0))),
              (kMiss + 0.5 * (1 - kMiss)) / (1 - kFalse), 1e-6);
  const auto point = table_of({}, ClutterModel::point);
  EXPECT_NEAR(std::exp(log_ratio(point, nullptr, in_beam_45(150.0))), kMiss + 0.5 * (1 - kMiss), 1e-6);
}

TEST(SensorLikelihood, ToleranceWidensAndLowersTheReturn) {
  const auto table = table_of({{core::radians(0.5), 80.0, 1}}, ClutterModel::exclusive_beam);
  const double wide = log_ratio(table, nullptr, in_beam_45(84.0), {.sigma_scale = 2.0});
  const double two_sigma = (1 - kMiss) * gaussian(2.0) / 2.0 * 150.0 / kFalse;  // 4 m are one wide sigma.
  EXPECT_NEAR(std::exp(wide), two_sigma + std::exp(-8.0), 1e-3);
}

TEST(SensorLikelihood, AveragesOneBehindAnOwnedBeam) {
  BeamMask mask;
  const auto silent = table_of({}, ClutterModel::exclusive_beam);
  mask.clear(silent);
  claim_beam(silent, 45, 60.0, 0.7, mask);
  EXPECT_NEAR(mean_under_clutter(ClutterModel::exclusive_beam, &mask), 1.0, 1e-4);
}

TEST(SensorLikelihood, PointSensorIsPoissonClutterAndOneReturn) {
  const auto table = table_of({{0.10, 80.0, 1}, {-0.2, 30.0, 1}}, ClutterModel::point);
  const double density = 4.0 / (150.0 * core::radians(90.0));
  const double peak = 1.0 / (2 * std::numbers::pi * kSigma * 0.02);
  EXPECT_NEAR(log_ratio(table, nullptr, core::from_polar(80.0, 0.10)),
              std::log(kMiss + (1 - kMiss) * peak / density), 1e-5);
  EXPECT_NEAR(log_ratio(table, nullptr, core::from_polar(80.0, 0.4)), std::log(kMiss), 1e-5);
  EXPECT_EQ(log_ratio(table, nullptr, core::from_polar(80.0, 0.8)), 0.0);
}

std::vector<core::SonarReturn> random_returns(core::Random& random) {
  std::vector<core::SonarReturn> returns;
  for (int beam = 0; beam < 90; ++beam)
    if (random.bernoulli(0.5)) returns.push_back({core::radians(beam - 44.5), random.uniform(0.1, 150.0), 1});
  return returns;
}

class FastAgainstPlain : public testing::TestWithParam<ClutterModel> {};

TEST_P(FastAgainstPlain, AgreesEverywhere) {
  core::Random random(1001);
  const auto table = table_of(random_returns(random), GetParam(), {12.0, -7.0, 2.5});
  BeamMask mask;
  mask.clear(table);
  if (GetParam() == ClutterModel::point)
    claim_detection(3, 0.8, mask);
  else
    for (int beam = 10; beam < 60; ++beam) claim_beam(table, beam, 50.0, 0.6, mask);
  std::vector<double> north(1000), east(1000), vn(1000), ve(1000), fast(1000, 0.0), free(1000, 0.0);
  for (std::size_t i = 0; i < 1000; ++i) {
    north[i] = random.uniform(-160, 160), east[i] = random.uniform(-160, 160);
    vn[i] = random.uniform(-5, 5), ve[i] = random.uniform(-5, 5);
  }
  // Few hypotheses are near an edge softened over .02 of a beam, most near one softened over half: two ways.
  for (const double softness : {0.02, 0.1, 0.5}) {
    const Tolerance tolerance{1.0, softness};
    std::fill(fast.begin(), fast.end(), 0.0);
    std::fill(free.begin(), free.end(), 0.0);
    add_log_ratio(table, &mask, {north, east, vn, ve}, -3.0, tolerance, fast);
    add_log_ratio(table, nullptr, {north, east, vn, ve}, -3.0, tolerance, free);
    for (std::size_t i = 0; i < 1000; ++i) {
      const Eigen::Vector2d p_earth(north[i] - 3 * vn[i], east[i] - 3 * ve[i]);
      // Single precision of the ranges, and 1e-6 rad of the angle, at an edge 2 x softness beams wide.
      EXPECT_NEAR(fast[i], log_ratio(table, &mask, p_earth, tolerance), 2e-2) << p_earth.transpose();
      EXPECT_NEAR(free[i], log_ratio(table, nullptr, p_earth, tolerance), 2e-2) << p_earth.transpose();
    }
  }
}

TEST_P(FastAgainstPlain, ProductsAreTheSumsOfLogarithms) {
  core::Random random(1002);
  const auto table = table_of(random_returns(random), GetParam());
  std::vector<double> north(100), east(100), velocity(100, 0.0), product(100, 2.0), sum(100, std::log(2.0));
  for (std::size_t i = 0; i < 100; ++i) north[i] = random.uniform(0, 160), east[i] = random.uniform(-80, 80);
  multiply_by_ratio(table, nullptr, {north, east, velocity, velocity}, 0.0, {}, product);
  add_log_ratio(table, nullptr, {north, east, velocity, velocity}, 0.0, {}, sum);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_NEAR(std::log(product[i]), sum[i], 1e-5);
}

TEST(SensorLikelihood, LocatesFromTheScansAxis) {
  const auto table = table_of({}, ClutterModel::exclusive_beam, {10.0, 0.0, core::radians(90.0)});
  const std::vector<double> north{10.0, 13.0}, east{50.0, 4.0}, rate{0.0, 1.0}, zero{0.0, 0.0};
  std::array<float, 2> range{}, bearing{};
  locate(table, {north, east, rate, zero}, -3.0, range, bearing);
  EXPECT_NEAR(range[0], 50.0, 1e-4);  // Due east, along the axis.
  EXPECT_NEAR(bearing[0], 0.0, 1e-6);
  EXPECT_NEAR(range[1], 4.0, 1e-4);  // Three seconds ago at (10, 4).
  EXPECT_NEAR(bearing[1], 0.0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Models, FastAgainstPlain,
                         testing::Values(ClutterModel::exclusive_beam, ClutterModel::shared_beam,
                                         ClutterModel::point));

TEST(SensorLikelihood, BirthsJoinThoseThatWereThere) {
  std::vector<double> values{-200.0, -7.6, 3.0, 60.0};
  add_births(-7.6, values);
  EXPECT_NEAR(values[0], -7.6, 1e-6);
  EXPECT_NEAR(values[1], -7.6 + std::log(2.0), 1e-6);
  EXPECT_NEAR(values[2], std::log(std::exp(3.0) + std::exp(-7.6)), 1e-6);
  EXPECT_NEAR(values[3], 60.0, 1e-6);
}

TEST(SensorLikelihood, AWholeCircleHasNoEdge) {
  core::PosedScan posed = posed_scan({{core::radians(-179.5), 40.0, 1}});
  posed.scan.num_beams = 360;
  posed.scan.first_bearing = core::radians(-179.5);
  ScanTable table;
  fill_scan_table(posed, table);
  set_figures(kFigures, {}, table);
  const double on_seam = log_ratio(table, nullptr, core::from_polar(40.0, core::radians(-180.0)));
  const double inside = log_ratio(table, nullptr, core::from_polar(40.0, core::radians(-179.5)));
  EXPECT_NEAR(std::exp(on_seam), 0.5 * (std::exp(inside) + kMiss / (1 - kFalse)), 1e-3);
}

// Beam by beam an uneven scan says what an even one says whose beams heard the same.
TEST(SensorLikelihood, UnevenBeamsSayWhatEvenOnesSayOfTheSameBeams) {
  const auto fan = sine_fan();
  core::Random random(1003);
  core::PosedScan even = posed_scan({}), uneven = posed_scan({});
  uneven.scan.fan = fan;
  for (int beam = 3; beam < 90; beam += 4) {
    const double range = random.uniform(5.0, 145.0);
    even.scan.returns.push_back({core::radians(beam - 44.5), range, 1.0});
    uneven.scan.returns.push_back({fan->centre(beam), range, 1.0});
  }
  ScanTable even_table, uneven_table;
  for (const auto& [scan, table] : {std::pair(&even, &even_table), std::pair(&uneven, &uneven_table)}) {
    fill_scan_table(*scan, *table);
    set_figures(kFigures, {.clutter = ClutterModel::exclusive_beam}, *table);
  }
  std::vector<double> north(500), east(500), still(500, 0.0), fast(500, 0.0), plain(500);
  for (std::size_t i = 0; i < 500; ++i) {
    const double range = random.uniform(1.0, 149.0), place = random.uniform(-0.49, 89.49);
    const Eigen::Vector2d at = core::from_polar(range, fan->bearing_at(place));
    north[i] = at.x(), east[i] = at.y();
    plain[i] = log_ratio(uneven_table, nullptr, at);
    EXPECT_NEAR(plain[i],
                log_ratio(even_table, nullptr, core::from_polar(range, core::radians(place - 44.5))), 1e-6);
  }
  add_log_ratio(uneven_table, nullptr, {north, east, still, still}, 0.0, {}, fast);
  for (std::size_t i = 0; i < 500; ++i) EXPECT_NEAR(fast[i], plain[i], 2e-2);
}

}  // namespace
}  // namespace lookout::csht
