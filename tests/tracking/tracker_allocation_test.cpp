// What the trackers allocate per scan once they are warm. A program of its own: the counter replaces operator
// new.
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/sonar_scene.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tracking {
namespace {

/// Scan `k`: two targets at rest, detected four times of five, and as many false alarms.
core::PosedScan noisy_scan(int k, int num_false, core::Random& random) {
  std::vector<Eigen::Vector2d> points;
  if (k % 5 != 0) points = {{60.0, -20.0}, {90.0, 20.0}};
  for (int j = 0; j < num_false; ++j)
    points.emplace_back(random.uniform(70.0, 100.0), random.uniform(-40.0, 40.0));
  return scan_of(k, points);
}

/// A tracker and its birth method; empty: its own.
struct Case {
  std::string tracker;
  std::string initiator;
  int many_false = 16;  // In a warm-up scan; fewer for joint, which takes its time over clutter so dense.
};

class TrackerAllocation : public ::testing::TestWithParam<Case> {};

TEST_P(TrackerAllocation, NothingPerScanOnceWarm) {
  constexpr int kWarm = 100, kCalm = 40, kCounted = 100;
  constexpr int kFewFalse = 4;  // buffers follow the densest scans so far
  ChainParams params;
  params.tracker.name = GetParam().tracker;
  params.tracker.initiator = GetParam().initiator;
  const auto pipeline = make_pipeline(params, {});
  core::Random random(1001);
  std::size_t allocated = 0;
  for (int k = 0; k < kWarm + kCalm + kCounted; ++k) {
    const auto scan = noisy_scan(k, k < kWarm ? GetParam().many_false : kFewFalse, random);
    const std::size_t before = lookout::testing::allocations();
    pipeline->step(scan);
    if (k >= kWarm + kCalm) allocated += lookout::testing::allocations() - before;
  }
  EXPECT_EQ(allocated, 0U);
}

// The Kalman baseline is left out: MRPT's engine allocates in every iteration.
INSTANTIATE_TEST_SUITE_P(Trackers, TrackerAllocation,
                         ::testing::Values(Case{"csht", ""}, Case{"gnn", ""}, Case{"gnn", "vct"},
                                           Case{"joint", "", 6}),
                         [](const auto& info) { return info.param.tracker + info.param.initiator; });

}  // namespace
}  // namespace lookout::tracking
