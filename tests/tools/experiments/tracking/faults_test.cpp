#include "tools/experiments/tracking/faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/input_error.hpp"

namespace lookout::tools {
namespace {

TEST(Faults, HasARowForEveryShippedPlan) {
  std::size_t plans = 0;
  for (const auto& file : std::filesystem::directory_iterator(LOOKOUT_SOURCE_DIR "/tools/scenarios/faults")) {
    const auto names = fault_names();
    EXPECT_NE(std::find(names.begin(), names.end(), file.path().stem().string()), names.end()) << file.path();
    ++plans;
  }
  EXPECT_EQ(fault_names().size(), plans + 1);  // And one without a fault.
  EXPECT_THROW(expected_counts("absent", {}), core::InputError);
}

/// Each fault, once, on Table 7's scene.
class FaultsTest : public ::testing::TestWithParam<std::string> {};

// What came is accounted for, the counters say what the fault did, the damage ends no later than a target is
// confirmed without a fault, and two seconds, and no fault makes a second false track.
TEST_P(FaultsTest, IsCountedSurvivedAndOver) {
  constexpr double kMore = 2.0;      // s
  constexpr double kOneFalse = 1.1;  // in 100 s, of a scene of 99.5
  const Metrics metrics = rehearse(GetParam(), 1000, 0, false);
  EXPECT_EQ(metrics.at("accounted").value, 1.0);
  EXPECT_EQ(metrics.at("counts_exact").value, 1.0)
      << "dropped " << metrics.at("dropped").value << ", rejected " << metrics.at("rejected").value
      << ", resets " << metrics.at("resets").value;
  EXPECT_LE(metrics.at("recovery_s").value, metrics.at("time_to_confirm_without_s").value + kMore);
  EXPECT_LE(metrics.at("false_per_100s").value, metrics.at("false_per_100s_without").value + kOneFalse);
}

INSTANTIATE_TEST_SUITE_P(Every, FaultsTest, ::testing::ValuesIn(fault_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace lookout::tools
