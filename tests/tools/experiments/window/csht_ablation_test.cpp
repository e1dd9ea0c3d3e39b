#include "tools/experiments/window/csht_ablation.hpp"

#include <gtest/gtest.h>

#include "tools/experiments/window/csht_ladder.hpp"

namespace lookout::tools {
namespace {

// Every rung, 20 points of the paper's tables, both readings of clutter.
TEST(CshtAblation, HoldsEveryRungInBothReadings) {
  const auto cells = make_csht_ablation()->cells();
  EXPECT_EQ(cells.size(), ladder_rungs().size() * 20 * 2);
  for (const auto& cell : cells) EXPECT_TRUE(cell.paper.contains("position_ospa"));
}

TEST(CshtAblation, CountsTheClasses) {
  const auto experiment = make_csht_ablation();
  for (const auto& cell : experiment->cells()) {
    if (cell.parameters.text("variant") != "E_3") continue;
    const Metrics metrics = experiment->run(cell, 1000, 0);
    EXPECT_GE(metrics.at("classes").value, 1.0);
    EXPECT_TRUE(metrics.contains("found"));
    return;
  }
  FAIL() << "no cell of E_3";
}

}  // namespace
}  // namespace lookout::tools
