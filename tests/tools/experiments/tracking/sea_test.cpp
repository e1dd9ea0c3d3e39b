#include "tools/experiments/tracking/sea.hpp"

#include <gtest/gtest.h>

#include "tools/experiments/tracking/sea_scene.hpp"

namespace lookout::tools {
namespace {

Metrics metrics_of(const std::string& condition) {
  const auto experiment = make_sea();
  for (const Cell& cell : experiment->cells())
    if (cell.method == "gnn" && cell.parameters.text("condition") == condition)
      return experiment->run(cell, 1000, 0);
  return {};
}

TEST(Sea, HasEveryConditionUnderEveryKnowledge) {
  std::size_t unknown_joint = 0;
  for (const Cell& cell : make_sea()->cells())
    unknown_joint += cell.method == "joint" && cell.parameters.text("sensor_figures") == "unknown" ? 1 : 0;
  EXPECT_EQ(unknown_joint, 2 * sea_targets().size() * sea_conditions().size());  // at .1 and at .3
}

TEST(Sea, ARunOfTheNearestNeighbourHasAllFigures) {
  const Metrics metrics = metrics_of("uniform");
  for (const char* name : {"ospa", "ospa_localization", "ospa_cardinality", "ospa_later", "gospa",
                           "identities", "false_per_100s", "false_per_100s_later", "num_tracks", "time_ms", "time_ms_median", "time_ms_p99"})
    EXPECT_TRUE(metrics.count(name)) << name;
  EXPECT_LE(metrics.at("ospa").value, 20.0);
}

// The nearest neighbour knows nothing of what stands or is dense: twenty beams that always return something
// between 60 and 90 m carry it away.
TEST(Sea, ADensePatchCostsMoreThanTheUniformSea) {
  EXPECT_GT(metrics_of("patch").at("ospa").value, metrics_of("uniform").at("ospa").value);
}

}  // namespace
}  // namespace lookout::tools
