#include "tracking/detection/speckle_grain.hpp"

#include <gtest/gtest.h>

#include "tests/support/speckle_images.hpp"
#include "tracking/detection/gain_background.hpp"

namespace lookout::tracking {
namespace {

EchoExtent grain_of(const lookout::testing::SpecklePlan& plan) {
  lookout::testing::SpeckleImages images(plan, 11);
  GainBackground background({}, ImageValues::amplitude);
  SpeckleGrain grain;
  for (int ping = 0; ping < 3; ++ping)
    grain.add(background.normalise(images.next().intensity, plan.num_beams, plan.num_bins));
  return grain.extent();
}

TEST(SpeckleGrain, IndependentCellsAreGrainsOfOneCell) {
  const EchoExtent extent = grain_of({});
  EXPECT_EQ(extent.beams, 1.0);
  EXPECT_EQ(extent.bins, 1.0);
}

// The speckle is drawn through the echo of a point: 2.5 beams wide, 6 bins long. Bright cells are cut off,
// which narrows the correlation a little.
TEST(SpeckleGrain, SpeckleHasTheGrainOfTheEcho) {
  lookout::testing::SpecklePlan plan;
  plan.grainy = true;
  plan.wide_beams = 2.5;
  plan.long_bins = 6.0;
  const EchoExtent extent = grain_of(plan);
  EXPECT_NEAR(extent.beams, 2.5, 0.3);
  EXPECT_NEAR(extent.bins, 6.0, 0.7);
}

TEST(SpeckleGrain, BeforeAnyImageItIsOneCell) {
  EXPECT_EQ(SpeckleGrain().extent().bins, 1.0);
}

}  // namespace
}  // namespace lookout::tracking
