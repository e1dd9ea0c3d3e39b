#include "tools/experiments/tracking/faulted_run.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "tools/cli/paths.hpp"

namespace lookout::tools {
namespace {

sonar_sim::Scene crossing() {
  sonar_sim::Scene scene = sonar_sim::load_scene(tools_directory() + "/scenarios/crossing.yaml");
  scene.duration = 20.0;
  return scene;
}

TEST(FaultedRun, WithoutFaultsEveryScanIsTracked) {
  const FaultedRun run = run_through({}, crossing(), 1, 0);
  EXPECT_EQ(run.counts.accepted, static_cast<std::int64_t>(run.truth.size()));
  EXPECT_EQ(run.tracks.size(), run.truth.size());
  EXPECT_EQ(run.rejected() + run.counts.lost, 0);
  EXPECT_TRUE(run.accounted());
}

TEST(FaultedRun, CountsWhatTheFaultTook) {
  const FaultPlan plan = read_fault_plan("faults: [{kind: off, from: 5, to: 10}]", "plan");
  const FaultedRun run = run_through(plan, crossing(), 1, 0);
  EXPECT_EQ(run.counts.lost, run.faulted_scans.faults.withheld);
  EXPECT_GT(run.counts.lost, 0);
  EXPECT_TRUE(run.accounted());
}

TEST(FaultedRun, RefusesAPlanThatIsNotShipped) {
  EXPECT_THROW(shipped_plan("absent"), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
