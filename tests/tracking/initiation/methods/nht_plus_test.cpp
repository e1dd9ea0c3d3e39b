#include "tracking/initiation/methods/nht_plus.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/initiation/initiator_test_scene.hpp"

namespace lookout::tracking {
namespace {

NhtPlusParams params() {
  NhtPlusParams result;
  result.speeds = {100.0, 400.0};
  return result;
}

double highest(const PlotWindow& window) {
  NhtPlusInitiator method(params());
  method.start(window);
  return test::votes_of(method).highest;
}

TEST(NhtPlus, AStepContributesItsLargestVote) {
  // Two targets on one course, one behind the other at the same speed: every step has two pairs for one cell.
  core::Random random(1028);
  const test::Course first{{0, 0}, {250, 0}}, second{{5000, 0}, {250, 0}};
  const double one = highest(test::scene_of({first}, {}, random));
  EXPECT_GT(one, 5.5);
  EXPECT_LE(one, 6.0);  // Six steps of seven scans.
  EXPECT_LE(highest(test::scene_of({first, second}, {}, random)), 6.0);
}

TEST(NhtPlus, SpeedsOnOneLineDoNotAddUp) {
  // Two pairs along one line, at 150 and at 350 m/s: bins of speed are a few m/s wide.
  PlotWindow window;
  Plot plot;
  plot.noise = 25.0 * Eigen::Matrix2d::Identity();
  for (const double x : {0.0, 300.0, 1000.0}) {
    window.begin_scan(2.0 * window.num_scans());
    plot.position = {x, 0.0};
    window.add(plot);
  }
  const double value = highest(window);
  EXPECT_GT(value, 0.9);
  EXPECT_LE(value, 1.0);
}

TEST(NhtPlus, VotesOverTheEndOfThetaReachTheSameCell) {
  // A course along theta = 0, so that half of its votes lie beyond the end of theta: the peak must be as high
  // as that of the same course turned away from the end.
  core::Random random(1029);
  const double at_the_end = highest(test::scene_of({{{1000, 0}, {0, 250}}}, {}, random));
  const double inside = highest(test::scene_of({{{0, 1000}, {250, 0}}}, {}, random));
  EXPECT_NEAR(at_the_end, inside, 0.3);  // Half a cell of 1/8 sigma across and 1/2 along each way.
}

TEST(NhtPlus, RefusesBadParameters) {
  const auto refused = [](auto spoil) {
    NhtPlusParams bad = params();
    spoil(bad);
    EXPECT_THROW(NhtPlusInitiator{bad}, std::invalid_argument);
  };
  refused([](auto& p) { p.min_plots = 2; });
  refused([](auto& p) { p.window_scans = 1; });
  refused([](auto& p) { p.peak_threshold = 0.0; });
  refused([](auto& p) { p.chain_probability = 1.0; });
  refused([](auto& p) { p.max_tracks = 0; });
}

}  // namespace
}  // namespace lookout::tracking
