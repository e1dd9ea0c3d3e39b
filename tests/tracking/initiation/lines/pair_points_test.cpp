#include "tracking/initiation/lines/pair_points.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

/// One plot, then three: 0, 300 and 900 m away, 2 s later.
PlotWindow two_scans() {
  PlotWindow window;
  Plot plot;
  plot.position = {10.0, 0.0};
  window.begin_scan(0.0);
  window.add(plot);
  window.begin_scan(2.0);
  window.add(plot);
  plot.position = {310.0, 0.0};
  window.add(plot);
  plot.position = {10.0, 900.0};
  window.add(plot);
  return window;
}

TEST(PairPoints, WithoutLimitsEveryPairButTheCoincidingOne) {
  PairFormation formation({}, 100);
  EXPECT_EQ(formation.form(two_scans(), 1, {0, 0}).size(), 2u);
}

TEST(PairPoints, SpeedLimitsRefuseWhatIsTooFast) {
  PairFormation formation(kFanSpeeds, 100);  // 200 to 800 m in 2 s
  const auto& pairs = formation.form(two_scans(), 1, {0, 0});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].newer, 2);
  EXPECT_NEAR(pairs[0].line.rho, 0.0, 1e-9);
}

TEST(PairPoints, AMarginWidensTheLimits) {
  PairFormation formation(kFanSpeeds, 100, 101.0);  // 99 to 901 m
  EXPECT_EQ(formation.form(two_scans(), 1, {0, 0}).size(), 2u);
  EXPECT_THROW(PairFormation(kFanSpeeds, 100, -1.0), std::invalid_argument);
}

TEST(PairPoints, SaysWhenAWindowIsTooMuch) {
  PairFormation formation({}, 1);
  formation.form(two_scans(), 1, {0, 0});
  EXPECT_TRUE(formation.exceeded());
  EXPECT_NE(formation.refusal().find("more than 1 pairs"), std::string::npos);
}

TEST(PairPoints, NeighboursAreFoundOverTheWrap) {
  std::vector<PairPoint> pairs{
      {0, 1, {-20.0, 3.14}, 1.0}, {0, 2, {20.0, 0.002}, 1.0}, {0, 3, {20.0, 1.0}, 1.0}};
  sort_by_theta(pairs);
  int found = 0;
  for_pairs_near(pairs, {21.0, 0.0}, 0.01, 5.0, [&](const PairPoint& pair, const NormalLine& apart) {
    ++found;
    EXPECT_NE(pair.newer, 3);
    EXPECT_NEAR(apart.rho, -1.0, 1e-12);
  });
  EXPECT_EQ(found, 2);
}

}  // namespace
}  // namespace lookout::tracking
