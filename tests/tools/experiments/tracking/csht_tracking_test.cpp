#include "tools/experiments/tracking/csht_tracking.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "core/files/csv.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

TEST(CshtTracking, HasBothReadingsAndThePapersFigures) {
  const auto cells = make_csht_tracking()->cells();
  int light = 0, printed = 0, delayed = 0;
  for (const auto& cell : cells) {
    delayed += cell.parameters.number("lag_s") > 0.0 ? 1 : 0;
    if (cell.method != "kalman") continue;
    light += cell.parameters.text("clutter") == "light" ? 1 : 0;
    printed += cell.paper.contains("ospa_cardinality") ? 1 : 0;
  }
  EXPECT_EQ(light, 20);    // 16 pairs of probabilities and four further sigmas
  EXPECT_EQ(printed, 40);  // in both readings
  EXPECT_EQ(delayed, 80);  // joint, 5 and 10 s
}

// The paper's estimator to the letter runs under the tracker of `csht`: a run has all its figures.
TEST(CshtTracking, RunsThePrintedEstimator) {
  const auto experiment = make_csht_tracking();
  for (const auto& cell : experiment->cells()) {
    if (cell.method != "csht_printed") continue;
    const Metrics metrics = experiment->run(cell, 1000, 0);
    EXPECT_GT(metrics.at("ospa").value, 0.0);
    EXPECT_TRUE(metrics.contains("bound"));
    return;
  }
  FAIL() << "no cell of csht_printed";
}

// [Yan2018] Tables 10 and 13 print the norm of Tables 8, 9, 11 and 12, to their two digits, in all 40 cells:
// so the total stands beside `ospa_of_means`, and nothing beside `ospa`, the mean of the scans' own totals.
TEST(CshtTracking, ComparesThePapersTotalWithItsOwnStatistic) {
  int compared = 0;
  for (const auto& cell : make_csht_tracking()->cells()) {
    EXPECT_FALSE(cell.paper.contains("ospa"));
    if (!cell.paper.contains("ospa_of_means") || cell.parameters.text("clutter") != "light") continue;
    const double norm = std::hypot(cell.paper.at("ospa_localization"), cell.paper.at("ospa_cardinality"));
    EXPECT_NEAR(cell.paper.at("ospa_of_means"), norm, 0.01);
    ++compared;
  }
  EXPECT_EQ(compared, 60);  // 20 points; csht, kalman, and csht_printed beside the paper's csht
}

// Two runs of the one cell that is left: a mean with its interval at each of the 200 scans, and no other
// tracker.
TEST(CshtTracking, DrawsTheMeanOfTheRunsOfWhatIsLeft) {
  const tests::TemporaryDirectory folder;
  const auto experiment = make_csht_tracking();
  Drawn drawn;
  drawn.seed = 1000;
  drawn.runs = 2;
  drawn.directory = folder.path();
  for (const auto& cell : experiment->cells())
    if (cell.method == "gnn" && drawn.cells.empty()) drawn.cells.push_back(cell);
  experiment->write_extras(drawn);
  constexpr std::array<std::string_view, 2> kColumns{"total", "total_ci95"};
  const core::CsvTable table(folder.file("ospa_gnn.csv"), kColumns);
  EXPECT_EQ(table.num_rows(), 200U);
  EXPECT_FALSE(table.empty(100, "total_ci95"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("ospa_joint.csv")));
}

}  // namespace
}  // namespace lookout::tools
