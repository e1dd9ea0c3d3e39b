#include "tools/experiments/tracking/sea.hpp"

#include <gtest/gtest.h>

#include "core/files/csv.hpp"
#include "tests/support/temporary_directory.hpp"
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
  for (const char* name :
       {"ospa", "ospa_localization", "ospa_cardinality", "ospa_later", "gospa", "identities",
        "false_per_100s", "false_per_100s_later", "num_tracks", "time_ms", "time_ms_median", "time_ms_p99"})
    EXPECT_TRUE(metrics.count(name)) << name;
  EXPECT_LE(metrics.at("ospa").value, 20.0);
}

// Twenty beams that always return something between 60 and 90 m cost even who learns where they are.
// The patch is dense in truth and as learnt; it is the same patch again where all is drawn again.
TEST(Sea, WritesWhatWasLearntOfTheClutterBesideTheTruth) {
  const auto experiment = make_sea();
  Drawn drawn{.seed = 3, .runs = 1, .jobs = 1, .cells = {}, .directory = {}};
  for (const Cell& cell : experiment->cells())
    if ((cell.method == "gnn" || cell.method == "jipda") && cell.parameters.text("condition") == "patch")
      drawn.cells.push_back(cell);
  const auto drawn_to = [&](const std::string& directory) {
    drawn.directory = directory;
    experiment->write_extras(drawn);
    return core::CsvTable(directory + "/clutter_patch.csv", {});
  };
  const tests::TemporaryDirectory first, second;
  const core::CsvTable table = drawn_to(first.path()), again = drawn_to(second.path());
  EXPECT_FALSE(table.has("jipda_db"));  // it learns none
  double truth = 0.0, learnt = 0.0, cells = 0.0;
  for (std::size_t row = 0; row < table.num_rows(); ++row) {
    EXPECT_EQ(table.text(row, "true_db"), again.text(row, "true_db"));
    EXPECT_EQ(table.text(row, "gnn_db"), again.text(row, "gnn_db"));
    const double bearing = table.number(row, "bearing_deg"), range = table.number(row, "range_m");
    if (bearing < 7.0 || bearing > 23.0 || range < 63.0 || range > 87.0) continue;
    truth += table.number(row, "true_db");
    learnt += table.number(row, "gnn_db");
    cells += 1.0;
  }
  EXPECT_NEAR(truth / cells, 16.5, 0.5);  // (.9 / 30 + .1 x .1 / 150) / (.1 / 150) = 45
  EXPECT_NEAR(learnt / cells, truth / cells, 4.0);
}

TEST(Sea, ADensePatchCostsMoreThanTheUniformSea) {
  EXPECT_GT(metrics_of("patch").at("ospa").value, metrics_of("uniform").at("ospa").value);
}

}  // namespace
}  // namespace lookout::tools
