#include <gtest/gtest.h>

#include "csht/estimator_registry.hpp"
#include "tests/csht/straight_scene.hpp"
#include "tests/support/allocation_counter.hpp"

namespace lookout::csht {
namespace {

class HotPath : public ::testing::TestWithParam<const char*> {};

// Warm after three windows of the same scans: the fourth is a repetition in all but its times, and asks the
// system for nothing.
TEST_P(HotPath, AllocatesNothingOnceWarm) {
  core::Random random(1);
  auto scans =
      testing::scans_of({{{80, 10}, {-1, 2}}, {{60, -30}, {2, 1}}}, 20, {3.0, 0.0, true, 0.3, 20}, random);
  const auto estimator = make_estimator(GetParam(), {}, testing::sonar(), 1);
  const core::Track track;
  std::size_t before = 0;
  for (int window = 0; window < 4; ++window) {
    if (window == 3) before = lookout::testing::allocations();
    for (auto& scan : scans) {
      estimator->offer({{&track, 1}});
      estimator->update(scan);
      scan.scan.utime += 20 * 500'000;
    }
  }
  EXPECT_EQ(lookout::testing::allocations() - before, 0U);
}

INSTANTIATE_TEST_SUITE_P(Faithful, HotPath, ::testing::Values("csht", "csht_printed", "sht"));
INSTANTIATE_TEST_SUITE_P(Joint, HotPath, ::testing::Values("joint"));

}  // namespace
}  // namespace lookout::csht
