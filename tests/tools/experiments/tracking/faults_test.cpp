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
class FaultsTest : public ::testing::TestWithParam<std::string> {
 protected:
  static Metrics metrics_of(const std::string& name) {
    const auto experiment = make_faults();
    for (const Cell& cell : experiment->cells())
      if (cell.parameters.text("fault") == name) return experiment->run(cell, 1000, 0);
    return {};
  }
};

// What came is accounted for, the counters say what the fault did, and the damage ends: at most as much later
// as old tracks need to be disbelieved than with a tracker that is switched on at the fault's end, and at
// most a quarter of a minute.
TEST_P(FaultsTest, IsCountedSurvivedAndOver) {
  constexpr double kDisbelief = 7.0, kMost = 15.0;  // s; docs/faults.md has the figures.
  const Metrics metrics = metrics_of(GetParam());
  EXPECT_EQ(metrics.at("accounted").value, 1.0);
  EXPECT_EQ(metrics.at("counts_exact").value, 1.0)
      << "dropped " << metrics.at("dropped").value << ", rejected " << metrics.at("rejected").value
      << ", resets " << metrics.at("resets").value;
  if (GetParam() == "none") return;
  EXPECT_LE(metrics.at("recovery_s").value, std::min(kMost, metrics.at("fresh_s").value + kDisbelief));
}

INSTANTIATE_TEST_SUITE_P(Every, FaultsTest, ::testing::ValuesIn(fault_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace lookout::tools
