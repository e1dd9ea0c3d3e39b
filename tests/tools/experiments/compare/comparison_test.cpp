#include "tools/experiments/compare/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

constexpr int kRuns = 6;

ComparisonPlan small_plan() {
  return {{"calm", "rough"}, {"good", "bad"}, kRuns, {}};
}

/// Three scans; every column is 1 in run 0, 2 in run 1 ..., one more for the second method.
Curve toy_curve(std::size_t /*scene*/, std::size_t method, int run) {
  Curve curve;
  curve.utime = {0, 1'000'000, 2'000'000};
  for (auto& column : curve.values) column.assign(3, 1.0 + run + static_cast<double>(method));
  return curve;
}

struct Summary {
  std::vector<ComparedCell> cells;
  std::vector<std::string> order;
};

Summary toy_summary(int jobs) {
  const tests::TemporaryDirectory folder;
  KeyedLog log(folder.file("runs.jsonl"), {"compare", "", 1, kRuns, "", {}, {}}, {}, false);
  run_comparison(small_plan(), {}, jobs, toy_curve, log);
  Summary summary;
  summary.cells =
      summarise(small_plan(), log, [&](const auto& scene, const auto& method, int run, const Curve&) {
        summary.order.push_back(run_key(scene, method, run));
      });
  return summary;
}

TEST(Comparison, MeansAreOfTheRuns) {
  const Summary summary = toy_summary(2);
  ASSERT_EQ(summary.cells.size(), 4U);
  const ComparedCell& cell = summary.cells[0];
  EXPECT_EQ(cell.scene, "calm");
  EXPECT_EQ(cell.method, "good");
  EXPECT_DOUBLE_EQ(mean_interval(cell.runs[column_index("ospa")]).mean, 3.5);  // of 1 .. 6
  EXPECT_DOUBLE_EQ(cell.over_time.at(1'000'000)[column_index("ospa")].mean.mean, 3.5);
  // NEES over all pairs: (1 x 1 + 2 x 2 + ... + 6 x 6) / (1 + ... + 6) = 91 / 21.
  EXPECT_NEAR(cell.over_time.at(0)[column_index("nees")].mean.mean, 91.0 / 21.0, 1e-12);
  EXPECT_DOUBLE_EQ(cell.nees_in_bounds, 0.0);
}

TEST(Comparison, RunsAreReadInOrderWhateverTheThreads) {
  const Summary one = toy_summary(1), many = toy_summary(5);
  EXPECT_EQ(one.order, many.order);
  EXPECT_EQ(one.order.front(), "calm good run=0");
  EXPECT_EQ(one.order.back(), "rough bad run=5");
}

TEST(Comparison, EveryPairOfMethodsIsTestedOnEveryScene) {
  const auto pairs = compare_pairs(small_plan(), toy_summary(1).cells);
  const auto tested =
      std::count_if(kCurveColumns.begin(), kCurveColumns.end(), [](const auto& c) { return c.is_tested; });
  EXPECT_EQ(pairs.size(), static_cast<std::size_t>(2 * tested));
  EXPECT_DOUBLE_EQ(pairs[0].test.difference, -1.0);  // the second method is one worse, always
  EXPECT_EQ(pairs[0].test.p, 0.0);
}

TEST(Comparison, AMissingRunIsNamed) {
  const tests::TemporaryDirectory folder;
  KeyedLog log(folder.file("runs.jsonl"), {"compare", "", 1, kRuns, "", {}, {}}, {}, false);
  run_comparison(small_plan(), {2, 2}, 1, toy_curve, log);
  const auto ignore = [](const auto&, const auto&, int, const Curve&) {};
  EXPECT_NE(testing::error_of([&] {
              summarise(small_plan(), log, ignore);
            }).find("run `calm good run=0` is missing"),
            std::string::npos);
}

TEST(Comparison, WhatTheLogHoldsIsNotRunAgain) {
  const tests::TemporaryDirectory folder;
  KeyedLog log(folder.file("runs.jsonl"), {"compare", "", 1, kRuns, "", {}, {}}, {}, false);
  run_comparison(small_plan(), {1, 2}, 1, toy_curve, log);
  int made = 0;
  run_comparison(
      small_plan(), {}, 1, [&](auto... task) { return ++made, toy_curve(task...); }, log);
  EXPECT_EQ(made, 2 * 2 * kRuns / 2);
}

}  // namespace
}  // namespace lookout::tools
