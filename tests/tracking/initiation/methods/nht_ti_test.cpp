#include "tracking/initiation/methods/nht_ti.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/initiation/initiator_test_scene.hpp"

namespace lookout::tracking {
namespace {

double votes_of(const NhtTiParams& params, const PlotWindow& window) {
  NhtTiInitiator method(params);
  method.start(window);
  return test::votes_of(method).sum;
}

/// Two scans of one target: one pair, its first step, 1 - P_F = 0.99. [Fan2018] Eq. (24) with no step before.
TEST(NhtTi, TheFirstStepVotesOneMinusFalseAlarms) {
  core::Random random(1010);
  test::SceneOptions options;
  options.scans = 2;
  NhtTiParams params;
  params.vote = NhtVote::cell;
  EXPECT_NEAR(votes_of(params, test::scene_of({{{0, 0}, {200, 0}}}, options, random)), 0.99, 1e-12);
}

/// A target that turns by a right angle at the third scan: no kernel agrees with the new leg, which is left
/// with the degree of falsity, P_F^2 = 1e-4, below the least vote.
TEST(NhtTi, ALegThatNoKernelAgreesWithDoesNotVote) {
  PlotWindow window;
  const double path[3][2] = {{0, 0}, {400, 0}, {400, 400}};
  for (int k = 0; k < 3; ++k) {
    window.begin_scan(2.0 * k);
    Plot plot;
    plot.position = {path[k][0], path[k][1]};
    window.add(plot);
  }
  NhtTiParams params;
  params.vote = NhtVote::cell;
  EXPECT_NEAR(votes_of(params, window), 0.99, 1e-12);
}

TEST(NhtTi, RefusesAProbabilityOutOfRange) {
  NhtTiParams params;
  params.false_alarm_probability = 1.0;
  EXPECT_THROW(NhtTiInitiator{params}, std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
