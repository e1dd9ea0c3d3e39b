#include "tracking/initiation/methods/mht_ti.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/initiation/initiator_test_scene.hpp"

namespace lookout::tracking {
namespace {

/// Two targets, at 250 m/s and at 20 m/s 5 km apart, in three scans.
double votes_of(Initiator& method) {
  core::Random random(1021);
  test::SceneOptions options;
  options.scans = 3;
  method.start(test::scene_of({{{0, 0}, {250, 0}}, {{0, 5000}, {0, 20}}}, options, random));
  return test::votes_of(method).sum;
}

TEST(MhtTi, EveryPairOfConsecutiveScansVotesOnce) {
  EXPECT_EQ(votes_of(*make_mht_ti({})), 2 * 4.0);  // Two steps of two times two plots.
}

TEST(MhtTi, OnePairAloneIsNoTrack) {
  core::Random random(1022);
  test::SceneOptions options;
  options.scans = 2;
  const auto method = make_mht_ti({});
  EXPECT_TRUE(method->start(test::scene_of({{{0, 0}, {250, 0}}}, options, random)).tracks.empty());
}

}  // namespace
}  // namespace lookout::tracking
