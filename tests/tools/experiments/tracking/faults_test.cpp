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

constexpr std::uint64_t kSeed = 1000;

// What came is accounted for, the counters say what the fault did, the damage ends no later than a target is
// confirmed without a fault, and two seconds, and no fault makes a second false track.
void expect_survived(const std::string& fault, const FaultedRun& clean) {
  constexpr double kMore = 2.0;      // s
  constexpr double kOneFalse = 1.1;  // in 100 s, of a scene of 99.5
  SCOPED_TRACE(fault);
  const Metrics metrics = rehearse(fault, clean, kSeed, 0, false);
  EXPECT_EQ(metrics.at("accounted").value, 1.0);
  EXPECT_EQ(metrics.at("counts_exact").value, 1.0)
      << "dropped " << metrics.at("dropped").value << ", rejected " << metrics.at("rejected").value
      << ", resets " << metrics.at("resets").value;
  EXPECT_LE(metrics.at("recovery_s").value, metrics.at("time_to_confirm_without_s").value + kMore);
  EXPECT_LE(metrics.at("false_per_100s").value, metrics.at("false_per_100s_without").value + kOneFalse);
}

/// Each fault, once, on Table 7's scene: one in so many a test, so that few runs without a fault are enough
/// for all.
constexpr std::size_t kGroups = 8;
class FaultsTest : public ::testing::TestWithParam<std::size_t> {};

TEST_P(FaultsTest, AreCountedSurvivedAndOver) {
  const FaultedRun clean = run_without_fault(kSeed, 0);
  const std::vector<std::string> names = fault_names();
  for (std::size_t k = GetParam(); k < names.size(); k += kGroups) expect_survived(names[k], clean);
}

INSTANTIATE_TEST_SUITE_P(EveryOf, FaultsTest, ::testing::Range(std::size_t{0}, kGroups));

}  // namespace
}  // namespace lookout::tools
