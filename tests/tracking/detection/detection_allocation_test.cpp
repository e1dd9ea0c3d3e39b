#include <gtest/gtest.h>

#include <vector>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/speckle_images.hpp"
#include "tracking/detection/image_detector.hpp"

namespace lookout::tracking {
namespace {

TEST(DetectionAllocation, AnImageAllocatesNothingOnceWarm) {
  lookout::testing::SpecklePlan plan;
  plan.grainy = true;  // So that the filter runs.
  plan.wide_beams = 2.0;
  plan.long_bins = 4.0;
  lookout::testing::SpeckleImages images(plan, 3);
  std::vector<core::SonarImage> pings;
  for (int ping = 0; ping < 40; ++ping) pings.push_back(images.next({{40.0, 200.0, 20.0}}));
  for (const auto& method : reference_level_names()) {
    DetectionParams params;
    params.reference.method = method;
    ImageDetector detector(params);
    for (int ping = 0; ping < 35; ++ping) detector.detect(pings[static_cast<std::size_t>(ping)]);
    const std::size_t before = lookout::testing::allocations();
    for (int ping = 35; ping < 40; ++ping) detector.detect(pings[static_cast<std::size_t>(ping)]);
    EXPECT_EQ(lookout::testing::allocations(), before) << method;
  }
}

}  // namespace
}  // namespace lookout::tracking
