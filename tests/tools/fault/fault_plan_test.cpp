#include "tools/fault/fault_plan.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

Fault only(const std::string& fault) {
  return read_fault_plan("faults: [" + fault + "]", "plan").faults.at(0);
}

std::string refusal(const std::string& fault) {
  try {
    only(fault);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return {};
}

TEST(FaultPlan, ReadsEveryKindWithItsOwnKeys) {
  EXPECT_EQ(only("{kind: off, channel: all, from: 1, to: 2}").streams.size(), 3u);
  EXPECT_EQ(only("{kind: wrong, how: scale, factor: 3}").factor, 3.0);
  EXPECT_EQ(only("{kind: intermittent, off: 1, on: 2}").on, 2.0);
  EXPECT_EQ(only("{kind: sequence_jump, jump: -5}").jump, -5);
  EXPECT_TRUE(only("{kind: flood, copies: 2, content: garbage}").copies_are_garbage);
  EXPECT_EQ(only("{kind: clock_drift, rate: 0.01, channel: vehicle}").streams, std::vector{Stream::vehicle});
}

TEST(FaultPlan, RefusesWhatWouldHaveNoEffect) {
  EXPECT_NE(refusal("{kind: off, share: 0.5}").find("share"), std::string::npos);
  EXPECT_NE(refusal("{kind: clock_step, step: 0}").find("do nothing"), std::string::npos);
  EXPECT_NE(refusal("{kind: wrong, how: mirrored, factor: 2}").find("factor"), std::string::npos);
  EXPECT_NE(refusal("{kind: lost, from: 5, to: 5}").find("after `from`"), std::string::npos);
  EXPECT_NE(refusal("{kind: stuck, channel: image}").find("scan"), std::string::npos);
  EXPECT_NE(refusal("{kind: broken}").find("sequence_jump"), std::string::npos);
  EXPECT_NE(refusal("{channel: scan}").find("kind"), std::string::npos);
  EXPECT_THROW(read_fault_plan("faults: []", "plan"), core::InputError);
}

TEST(FaultPlan, EveryKindHasAShippedPlanAndEveryShippedPlanIsGood) {
  std::vector<bool> has(fault_kind_names().size(), false);
  for (const auto& file : std::filesystem::directory_iterator(LOOKOUT_SOURCE_DIR "/tools/scenarios/faults"))
    for (const auto& fault : load_fault_plan(file.path().string()).faults)
      has.at(static_cast<std::size_t>(fault.kind)) = true;
  for (std::size_t kind = 0; kind < has.size(); ++kind) EXPECT_TRUE(has[kind]) << fault_kind_names()[kind];
}

}  // namespace
}  // namespace lookout::tools
