#include "tools/cli/recorded_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tools/experiments/harness/simulated_run.hpp"

namespace lookout::tools {
namespace {

Configuration plain(const std::string& tracker) {
  Configuration configuration;
  configuration.tracker.name = tracker;
  configuration.estimator.name = "sht";
  return configuration;
}

TEST(ChainParams, TakeTheEstimatorThatTheConfigurationNames) {
  const auto scans = simulate(
      load_variant("tracking_table7.yaml", {0.1, 0.1, 1.0, sonar_sim::ClutterReading::light}), 1000, 0);
  for (const char* name : {"gnn", "csht"}) {
    const auto pipeline = tracking::make_pipeline(chain_params(plain(name), 1), {});
    std::size_t elements = 0;
    for (std::size_t k = 0; k < 60; ++k)  // 30 s, by when four targets are in view
      elements = std::max(elements, pipeline->step(scans[k].posed).elements.size());
    EXPECT_GE(elements, 2u) << name;
  }
}

core::VehicleState still(std::int64_t utime) {
  core::VehicleState state;
  state.utime = utime;
  return state;
}

TEST(RecordedChain, KeepsOneListAnAcceptedScan) {
  RecordedChain chain(plain("gnn"), 1);
  core::SonarScan scan;  // no return at all, which is an answer too
  scan.num_beams = 90;
  scan.first_bearing = core::radians(-44.5);
  scan.bearing_step = core::radians(1.0);
  scan.max_range = 150.0;
  chain.add(still(0));
  for (int k = 0; k < 4; ++k) {
    scan.utime = k * 500'000;
    scan.sequence = k;
    if (k != 2) chain.add(scan);
    chain.add(still(scan.utime + 100'000));
  }
  chain.finish();
  EXPECT_EQ(chain.counts().accepted, 3);
  EXPECT_EQ(chain.counts().lost, 1);
  ASSERT_EQ(chain.output().tracks.size(), 3u);
  EXPECT_EQ(chain.output().tracks[2].utime, 1'500'000);
  EXPECT_EQ(chain.output().elements.size(), 3u);
}

TEST(Describe, LeavesOutWhatDidNotHappen) {
  tracking::IntakeCounts counts;
  counts.accepted = 7;
  EXPECT_EQ(describe(counts), "7 scans tracked");
  counts.no_pose = 2;
  counts.lost = 1;
  EXPECT_EQ(describe(counts), "7 scans tracked, 2 rejected without a pose, 1 lost by sequence");
}

}  // namespace
}  // namespace lookout::tools
