#include "tracking/initiation/methods/iht_ti.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/initiation/initiator_test_scene.hpp"

namespace lookout::tracking {
namespace {

TEST(IhtTi, OnlyPairsWithinTheSpeedLimitsVote) {
  // At 250 m/s, at 20 m/s and far from both: of nine pairs a step the first target's own alone lies within
  // 100 to 400 m/s.
  core::Random random(1023);
  test::SceneOptions options;
  options.scans = 3;
  const auto method = make_iht_ti({});
  method->start(
      test::scene_of({{{0, 0}, {250, 0}}, {{0, 5000}, {0, 20}}, {{9000, 0}, {0, 900}}}, options, random));
  EXPECT_EQ(test::votes_of(*method).sum, 2.0);  // [Fan2018] Eq. (20), two steps.
}

}  // namespace
}  // namespace lookout::tracking
