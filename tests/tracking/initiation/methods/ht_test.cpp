#include "tracking/initiation/methods/ht.hpp"

#include <gtest/gtest.h>

#include "tests/tracking/initiation/initiator_test_scene.hpp"

namespace lookout::tracking {
namespace {

TEST(Ht, APlotVotesOnceInEveryColumn) {
  core::Random random(1020);
  test::SceneOptions options;
  options.scans = 2;
  const auto method = make_ht({});
  method->start(test::scene_of({{{700, -300}, {250, 0}}}, options, random));
  // [Fan2018] section V: columns of 0.001 rad, 3142 of them over pi; two plots.
  EXPECT_EQ(dynamic_cast<const HoughInitiator&>(*method).grid().num_theta(), 3142);
  EXPECT_EQ(test::votes_of(*method).sum, 2.0 * 3142);
}

}  // namespace
}  // namespace lookout::tracking
