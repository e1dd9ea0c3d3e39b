#include "tools/fault/fault_relay_node.hpp"

#include <gtest/gtest.h>

#include "core/frames.hpp"
#include "core/input_error.hpp"
#include "lcmtypes/convert.hpp"
#include "tests/tools/fault/fault_examples.hpp"

namespace lookout::tools {
namespace {

TEST(FaultRelayNode, RelaysFromOnePrefixToAnotherAndSpoils) {
  lcmtypes::Bus bus("memq://");
  std::vector<std::int64_t> heard;
  std::int64_t truths = 0;
  bus.subscribe<sonar_scan_t>("OUT_SONAR_SCAN",
                              [&](const core::SonarScan& scan) { heard.push_back(scan.sequence); });
  bus.subscribe<ground_truth_t>("OUT_GROUND_TRUTH", [&](const core::GroundTruth&) { ++truths; });
  FaultRelayNode relay(bus, bus, read_fault_plan("faults: [{kind: sequence_jump, jump: 10}]", "plan"),
                       {"IN_", "OUT_", 1});
  for (int k = 0; k < 3; ++k)
    bus.publish("IN_SONAR_SCAN", lcmtypes::to_wire(std::get<core::SonarScan>(example_scan(k, k).content)));
  bus.publish("IN_GROUND_TRUTH", lcmtypes::to_wire(core::GroundTruth{}));
  relay.run({.idle_exit = 0.1});
  bus.drain();
  EXPECT_EQ(heard, (std::vector<std::int64_t>{10, 11, 12}));
  EXPECT_EQ(truths, 1);
  EXPECT_EQ(relay.counts(Stream::scan).passed, 3);
}

TEST(FaultRelayNode, RefusesToFeedItself) {
  lcmtypes::Bus bus("memq://");
  const FaultPlan plan = read_fault_plan("faults: [{kind: off}]", "plan");
  EXPECT_THROW(FaultRelayNode(bus, bus, plan, {"A_", "A_", 1}), core::InputError);
}

}  // namespace
}  // namespace lookout::tools
