// The heights that docs/initiators.md states for [Fan2018] Situation I: three noise-free targets, no clutter.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/tracking/initiation/initiator_test_scene.hpp"
#include "tracking/initiation/initiator_registry.hpp"

namespace lookout::tracking {
namespace {

double highest_vote(const std::string& name, const std::string& variant = "") {
  core::Random random(1005);
  const PlotWindow window = test::scene_of(
      {{{300, 400}, {280, 49}}, {{3000, 300}, {-173.2, 100}}, {{2100, 1300}, {-173.2, -100}}}, {}, random);
  InitiatorConfig config;
  config.variant = variant;
  const auto method = make_initiator(name, config);
  EXPECT_EQ(method->start(window).tracks.size(), 3u);
  return test::votes_of(*method).highest;
}

TEST(HoughHeights, StandardTransformCountsEveryScan) {
  EXPECT_DOUBLE_EQ(highest_vote("ht"), 7.0);
}
TEST(HoughHeights, PairsCountEveryStep) {
  EXPECT_DOUBLE_EQ(highest_vote("mht_ti"), 6.0);
  EXPECT_DOUBLE_EQ(highest_vote("iht_ti"), 6.0);
}
TEST(HoughHeights, NeutrosophicFirstStepCountsOneMinusFalseAlarms) {
  EXPECT_NEAR(highest_vote("nht_ti", "cell"), 5.99, 1e-9);
  EXPECT_NEAR(highest_vote("nht_ti", "cell_chained"), 5.99, 1e-9);
  const double spread = highest_vote("nht_ti", "spread");
  EXPECT_GE(spread, 5.9);
  EXPECT_LE(spread, 6.0);
}
TEST(HoughHeights, NhtPlusCountsOneAStep) {
  EXPECT_GE(highest_vote("nht_plus"), 5.5);
  EXPECT_LE(highest_vote("nht_plus"), 6.0);
}

}  // namespace
}  // namespace lookout::tracking
