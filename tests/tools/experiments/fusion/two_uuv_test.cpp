#include "tools/experiments/fusion/two_uuv.hpp"

#include <gtest/gtest.h>

namespace lookout::tools {
namespace {

Metrics run_of(const std::string& method, const std::string& scenario) {
  const auto experiment = make_two_uuv();
  for (const Cell& cell : experiment->cells()) {
    if (cell.method == method && cell.parameters.text("scenario") == scenario &&
        cell.parameters.text("situation") == "steady")
      return experiment->run(cell, 1000, 0);
  }
  ADD_FAILURE() << method << " " << scenario;
  return {};
}

/// Passing one node on covers what both see as well as fusing does; the error of what both see tells them
/// apart.
TEST(TwoUuv, LocalisationTellsFusingFromJointCoverage) {
  const Metrics fused = run_of("learned", "two_uuv_fixed"), passed_on = run_of("single", "two_uuv_fixed");
  EXPECT_LT(fused.at("rmse").value, passed_on.at("rmse").value);
  EXPECT_GT(fused.at("held").value, 0.8);
  EXPECT_GT(fused.at("nees").value, 0.0);
}

TEST(TwoUuv, AcousticCellsNameTurnAndLoss) {
  int acoustic = 0;
  for (const Cell& cell : make_two_uuv()->cells()) {
    if (cell.parameters.text("situation") != "acoustic") continue;
    ++acoustic;
    EXPECT_GE(cell.parameters.number("turn_s"), 10.0);
    EXPECT_EQ(cell.parameters.number("loss"), 0.2);
  }
  EXPECT_EQ(acoustic, 9);
}

}  // namespace
}  // namespace lookout::tools
