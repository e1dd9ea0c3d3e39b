#include "csht/likelihood/blurred_likelihood.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/random.hpp"
#include "tests/csht/posed_scans.hpp"

namespace lookout::csht {
namespace {

constexpr double kMiss = 0.3, kFalse = 0.1;
constexpr double kSilence = kMiss / (1 - kFalse);

/// A scan whose heading is uncertain by `heading_beams` beams of a degree and its position by `position` [m].
ScanTable table_of(std::vector<core::SonarReturn> returns, double heading_beams, double position = 0.0,
                   int num_beams = 90) {
  core::PosedScan posed = posed_scan(std::move(returns));
  posed.scan.num_beams = num_beams;
  if (num_beams == 360) posed.scan.first_bearing = core::radians(-179.5);
  ScanTable table;
  fill_scan_table(posed, table);
  SensorFigures figures{kMiss, kFalse, 4.0, 2.0, 0.02};
  figures.heading_sigma = core::radians(heading_beams);
  figures.position_sigma = position;
  set_figures(figures, {}, table);
  return table;
}

double ratio_at(const ScanTable& table, double range, double bearing_deg) {
  return std::exp(log_ratio(table, nullptr, core::from_polar(range, core::radians(bearing_deg))));
}

TEST(BlurredLikelihood, AnExactPoseTakesTheHardBeams) {
  EXPECT_EQ(table_of({}, 0.0).blur_reach, 0);
  EXPECT_EQ(table_of({}, 0.7).blur_reach, 2);  // 2.5 sigma, rounded up.
}

TEST(BlurredLikelihood, WeighsEachBeamWithItsProbability) {
  const auto reported = table_of({{core::radians(0.5), 80.0, 1}}, 1.0);
  const double sharp = ratio_at(table_of({{core::radians(0.5), 80.0, 1}}, 0.0), 80.0, 0.5);
  // P(|x| < 1/2 beam) = 0.383 and P(1/2 < x < 3/2) = 0.242 of a unit normal, its logistic stand-in within
  // 0.02.
  EXPECT_NEAR(ratio_at(reported, 80.0, 0.5), 0.383 * sharp + 0.617 * kSilence, 0.02 * sharp);
  EXPECT_NEAR(ratio_at(reported, 80.0, 1.5), 0.242 * sharp + 0.758 * kSilence, 0.02 * sharp);
  EXPECT_NEAR(ratio_at(reported, 80.0, 20.5), kSilence, 1e-6);
}

TEST(BlurredLikelihood, APositionErrorBlursWhatIsNearAndNotWhatIsFar) {
  const auto reported = [](double range) { return table_of({{core::radians(0.5), range, 1}}, 0.1, 0.5); };
  const double sharp = ratio_at(table_of({{core::radians(0.5), 80.0, 1}}, 0.0), 80.0, 0.5);
  // Heading, edge and position together: 0.23 beams there, P(|x| < 1/2) = 0.970; 1.9 beams here, 0.207.
  EXPECT_NEAR(ratio_at(reported(140.0), 140.0, 0.5), 0.970 * sharp, 0.025 * sharp);
  EXPECT_NEAR(ratio_at(reported(15.0), 15.0, 0.5), 0.207 * sharp, 0.025 * sharp);
}

// Whatever the beams return, the mean over clutter is one: each beam's own ratio averages one.
TEST(BlurredLikelihood, AveragesOneUnderClutter) {
  core::Random random(1002);
  double sum = 0.0;
  constexpr int kScans = 20000;
  for (int scan = 0; scan < kScans; ++scan) {
    std::vector<core::SonarReturn> returns;
    for (int beam = 40; beam < 51; ++beam)
      if (random.bernoulli(kFalse))
        returns.push_back({core::radians(beam - 44.5), random.uniform(70.0, 90.0), 1});
    // Returns are drawn where they matter, 20 m of the 150 that the figures stand for.
    sum += ratio_at(table_of(returns, 0.7), 80.0, 0.8) - kMiss;
  }
  EXPECT_NEAR(sum / kScans * 20.0 / 150.0, (1.0 - kMiss), 0.05);
}

class FastBlurredAgainstPlain : public testing::TestWithParam<int> {};

TEST_P(FastBlurredAgainstPlain, AgreesEverywhere) {
  core::Random random(1001);
  std::vector<core::SonarReturn> returns;
  for (int beam = 0; beam < 90; ++beam)
    if (random.bernoulli(0.5)) returns.push_back({core::radians(beam - 44.5), random.uniform(0.1, 150.0), 1});
  const auto table = table_of(returns, 0.7, 0.4, GetParam());
  BeamMask mask;
  mask.clear(table);
  for (int beam = 10; beam < 60; ++beam) claim_beam(table, beam, 50.0, 0.6, mask);
  std::vector<double> north(1000), east(1000), still(1000, 0.0), fast(1000, 0.0), free(1000, 0.0);
  for (std::size_t i = 0; i < 1000; ++i)
    north[i] = random.uniform(-160, 160), east[i] = random.uniform(-160, 160);
  add_log_ratio(table, &mask, {north, east, still, still}, -3.0, {}, fast);
  add_log_ratio(table, nullptr, {north, east, still, still}, -3.0, {}, free);
  for (std::size_t i = 0; i < 1000; ++i) {
    const Eigen::Vector2d p_earth(north[i], east[i]);
    EXPECT_NEAR(fast[i], log_ratio(table, &mask, p_earth), 2e-3) << p_earth.transpose();  // Single precision.
    EXPECT_NEAR(free[i], log_ratio(table, nullptr, p_earth), 2e-3) << p_earth.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Beams, FastBlurredAgainstPlain, testing::Values(90, 360));

TEST(BlurredLikelihood, AWholeCircleHasNoEdge) {
  const auto table = table_of({{core::radians(-179.5), 40.0, 1}}, 1.0, 0.0, 360);
  EXPECT_NEAR(ratio_at(table, 40.0, 178.5), ratio_at(table, 40.0, -177.5),
              1e-6);  // Two beams to either side.
  EXPECT_GT(ratio_at(table, 40.0, 178.5), 2.0 * kSilence);
}

TEST(BlurredLikelihood, TheReturnTellsInWhichBeamTheTargetWas) {
  const auto table = table_of({{core::radians(1.5), 80.0, 1}}, 1.0);
  const BeamShares shares = beam_shares(table, core::from_polar(80.0, core::radians(0.5)), {});
  ASSERT_EQ(shares.count, 2 * table.blur_reach + 1);
  EXPECT_NEAR(std::accumulate(shares.share.begin(), shares.share.end(), 0.0), 1.0, 1e-12);
  const auto best = std::max_element(shares.share.begin(), shares.share.end()) - shares.share.begin();
  EXPECT_EQ(shares.beam[static_cast<std::size_t>(best)], 46);  // Beam 45 is centred on 0.5 degrees.
  EXPECT_GT(*std::max_element(shares.share.begin(), shares.share.end()), 0.9);
}

// One error of the heading goes over more of the narrow beams in the middle than of the wide ones outside.
TEST(BlurredLikelihood, NarrowBeamsAreBlurredMoreThanWideOnes) {
  const auto fan = sine_fan();
  const auto own_share = [&fan](int beam) {
    core::PosedScan scan = uneven_scan({{fan->centre(beam), 80.0, 1.0}});
    ScanTable table;
    fill_scan_table(scan, table);
    SensorFigures figures{kMiss, kFalse, 4.0, 2.0, 0.02};
    figures.heading_sigma = core::radians(0.5);
    set_figures(figures, {}, table);
    const Eigen::Vector2d at = core::from_polar(80.0, fan->centre(beam));
    const double north = at.x(), east = at.y(), still = 0.0;
    double fast = 0.0;
    add_log_ratio(table, nullptr, {{&north, 1}, {&east, 1}, {&still, 1}, {&still, 1}}, 0.0, {}, {&fast, 1});
    EXPECT_NEAR(fast, log_ratio(table, nullptr, at), 2e-2);
    return std::exp(log_ratio(table, nullptr, at));
  };
  // Half a beam is .90 sigma of .5 degrees in the middle (.90 degrees wide) and 1.17 near the edge: the
  // normal law keeps .633 and .759 there.
  EXPECT_NEAR(own_share(45) / own_share(85), 0.633 / 0.759, 0.03);
}

}  // namespace
}  // namespace lookout::csht
