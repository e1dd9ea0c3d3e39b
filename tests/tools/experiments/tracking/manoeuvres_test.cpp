#include "tools/experiments/tracking/manoeuvres.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tools/cli/paths.hpp"

namespace lookout::tools {
namespace {

TEST(Manoeuvres, EverySituationIsAScene) {
  for (const Cell& cell : make_manoeuvres()->cells()) {
    const std::string file = cell.parameters.text("situation") + ".yaml";
    EXPECT_TRUE(std::filesystem::exists(tools_directory() + "/scenarios/" + file)) << file;
  }
}

// The ratio of means, and its interval by the sum of squares of the relative ones: 0.3 and 0.4 make 0.5.
TEST(Manoeuvres, ComparesWithTheStraightTwin) {
  Estimates estimates{{"ospa", {3.0, 0.9, 5}}, {"ospa_twin", {2.0, 0.8, 5}}};
  make_manoeuvres()->complete(estimates);
  EXPECT_DOUBLE_EQ(estimates.at("ospa_over_twin").mean, 1.5);
  EXPECT_NEAR(estimates.at("ospa_over_twin").ci95, 0.75, 1e-12);
}

TEST(Manoeuvres, ARunOfTheNearestNeighbourHasAllFigures) {
  const auto experiment = make_manoeuvres();
  for (const Cell& cell : experiment->cells()) {
    if (cell.method != "gnn" || cell.parameters.text("situation") != "turn_6deg") continue;
    const Metrics metrics = experiment->run(cell, 1000, 0);
    EXPECT_EQ(metrics.at("posed_share").value, 1.0);
    EXPECT_GT(metrics.at("ospa_twin").value, 0.0);
    EXPECT_LE(metrics.at("ospa").value, 20.0);
    return;
  }
  FAIL() << "no such cell";
}

}  // namespace
}  // namespace lookout::tools
