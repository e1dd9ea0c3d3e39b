#include "tools/fault/fault_line.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/frames.hpp"
#include "tests/tools/fault/fault_examples.hpp"
#include "tools/fault/wire_message.hpp"

namespace lookout::tools {
namespace {

std::vector<std::vector<std::uint8_t>> bytes_through(const FaultPlan& plan, std::uint64_t seed,
                                                     FaultLine::Counts* counts) {
  std::vector<std::vector<std::uint8_t>> out;
  FaultLine line(plan, seed, [&out](const FaultMessage& message) { out.push_back(wire_bytes(message)); });
  for (int k = 0; k < 200; ++k) {
    line.take(example_state(0.5 * k));
    line.take(example_scan(0.5 * k, k));
  }
  line.finish();
  if (counts != nullptr) *counts = line.counts(Stream::scan);
  return out;
}

TEST(FaultLine, WithoutFaultsEverythingPassesUntouched) {
  std::int64_t passed = 0;
  FaultLine line({}, 1, [&passed](const FaultMessage& message) { passed += message.changed ? 0 : 1; });
  for (int k = 0; k < 5; ++k) line.take(example_scan(k, k));
  EXPECT_EQ(passed, 5);
}

TEST(FaultLine, FaultsStandInARow) {
  const TenScans both("{kind: off, from: 0, to: 5}, {kind: doubled}");
  EXPECT_EQ(both.out.size(), 10u);
}

TEST(FaultLine, PlanSeedAndTrafficAloneDecide) {
  const FaultPlan plan =
      read_fault_plan("faults: [{kind: garbage, share: 0.5}, {kind: lost, share: 0.2}]", "plan");
  EXPECT_EQ(bytes_through(plan, 7, nullptr), bytes_through(plan, 7, nullptr));
  EXPECT_NE(bytes_through(plan, 7, nullptr), bytes_through(plan, 8, nullptr));
}

TEST(FaultLine, EveryShippedPlanAccountsForEveryMessage) {
  for (const auto& file : std::filesystem::directory_iterator(LOOKOUT_SOURCE_DIR "/tools/scenarios/faults")) {
    FaultLine::Counts counts;
    bytes_through(load_fault_plan(file.path().string()), 1, &counts);
    EXPECT_EQ(counts.taken, 200) << file.path();
    EXPECT_EQ(counts.passed, counts.taken - counts.faults.withheld + counts.faults.added) << file.path();
  }
}

}  // namespace
}  // namespace lookout::tools
