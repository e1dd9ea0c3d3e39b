#include "tools/cli/images/found_returns.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/speckle_images.hpp"

namespace lookout::tools {
namespace {

TEST(FoundReturns, GivesTheScanOfEachWholeImage) {
  std::vector<std::int64_t> sequences;
  FoundReturns found{Configuration()};
  found.give_to([&](const core::SonarScan& scan) { sequences.push_back(scan.sequence); });
  lookout::testing::SpeckleImages images({}, 8);
  EXPECT_EQ(found.detector(), nullptr);
  found.add(images.next());
  core::SonarImage broken = images.next();
  broken.intensity.pop_back();
  found.add(broken);
  found.start_new_clock();
  found.add(images.next());
  EXPECT_EQ(sequences, (std::vector<std::int64_t>{0, 2}));
  EXPECT_EQ(found.counts().received, 3);
  EXPECT_EQ(found.counts().damaged, 1);
  EXPECT_EQ(found.ends_of_clocks(), std::vector<std::size_t>{1});
  ASSERT_NE(found.detector(), nullptr);
  EXPECT_EQ(found.detections().images, 2);
}

}  // namespace
}  // namespace lookout::tools
