#include "tools/experiments/tracking/over_time.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string_view>

#include "core/files/csv.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

constexpr std::array<std::string_view, 4> kColumns{"time_s", "total", "total_ci95", "num_tracks"};

// Totals 1 and 3 at a scan: mean 2, standard error 1, and Student's t with one degree of freedom is 12.7062.
TEST(OverTime, MeansHaveTheIntervalOfTheirRuns) {
  const tests::TemporaryDirectory folder;
  const ScoredScan low{500'000, 1.0, 1.0, 0.0, 2, 1}, high{500'000, 3.0, 0.0, 3.0, 2, 2};
  write_mean_over_time({{low}, {high}}, folder.file("ospa.csv"));
  const core::CsvTable table(folder.file("ospa.csv"), kColumns);
  ASSERT_EQ(table.num_rows(), 1U);
  EXPECT_EQ(table.number(0, "time_s"), 0.5);
  EXPECT_EQ(table.number(0, "total"), 2.0);
  EXPECT_NEAR(table.number(0, "total_ci95"), 12.7062, 1e-3);
  EXPECT_EQ(table.number(0, "num_tracks"), 1.5);
}

TEST(OverTime, ASingleRunHasNoInterval) {
  const tests::TemporaryDirectory folder;
  write_mean_over_time({{{0, 1.0, 1.0, 0.0, 1, 1}}}, folder.file("ospa.csv"));
  EXPECT_TRUE(core::CsvTable(folder.file("ospa.csv"), kColumns).empty(0, "total_ci95"));
}

// A target in view and no track: OSPA is the cut-off of 20 m, all of it cardinality.
TEST(OverTime, ScoresScanByScan) {
  TimedScan scan;
  scan.truth.targets.resize(1);
  scan.truth.targets[0].visible = true;
  TrackingOutput output;
  output.tracks.resize(1);
  const ScoredScans scored = score_scans({scan}, output);
  ASSERT_EQ(scored.size(), 1U);
  EXPECT_EQ(scored[0].total, 20.0);
  EXPECT_EQ(scored[0].cardinality, 20.0);
  EXPECT_EQ(scored[0].num_truth, 1);
}

}  // namespace
}  // namespace lookout::tools
