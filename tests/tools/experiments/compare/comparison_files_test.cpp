#include "tools/experiments/compare/comparison_files.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/files/text_file.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

ComparisonPlan small_plan() {
  ComparisonPlan plan{{"calm"}, {"good", "not_bad"}, 3, {}};
  plan.score.window = 7.0;
  return plan;
}

Curve toy_curve(std::size_t /*scene*/, std::size_t method, int run) {
  Curve curve;
  curve.utime = {0, 500'000};
  for (auto& column : curve.values) column.assign(2, 1.0 + run + static_cast<double>(method));
  return curve;
}

TEST(ComparisonFiles, HoldTheFiguresAndTheirOrigin) {
  const tests::TemporaryDirectory folder;
  const Study study{
      "compare", "lookout compare calm.yaml", 9, 3, "abc", words_of(small_plan()), {{"calm.yaml", "00"}}};
  KeyedLog log(folder.file("runs.jsonl"), study, {}, false);
  run_comparison(small_plan(), {}, 1, toy_curve, log);
  write_comparison(study, small_plan(), log, folder.path());
  const auto json = nlohmann::json::parse(core::read_text_file(folder.file("results.json"), "JSON"));
  EXPECT_EQ(json["experiment"], "compare");
  EXPECT_EQ(json["seed"], 9);
  EXPECT_EQ(json["commit"], "abc");
  EXPECT_EQ(json["inputs"]["calm.yaml"], "00");
  EXPECT_EQ(json["cells"][1]["method"], "not_bad");
  EXPECT_EQ(json["cells"][1]["metrics"]["ospa"]["mean"], 3.0);  // of 2, 3, 4
  EXPECT_EQ(json["tests"][0]["difference"], -1.0);
  const std::string curves = core::read_text_file(folder.file("curves.csv"), "CSV");
  EXPECT_TRUE(curves.starts_with("scene,method,run,time_s,ospa,")) << curves;
  EXPECT_EQ(std::count(curves.begin(), curves.end(), '\n'), 1 + 2 * 3 * 2);  // methods x runs x scans
  const std::string tex = core::read_text_file(folder.file("table.tex"), "LaTeX");
  EXPECT_NE(tex.find("not\\_bad & $3.000 \\pm 2.484$"), std::string::npos) << tex;  // t 4.303 x 1 / sqrt(3)
}

TEST(ComparisonFiles, AStudyHoldsItsPlan) {
  Study study;
  study.runs = 3;
  study.words = words_of(small_plan());
  const ComparisonPlan plan = plan_of(study);
  EXPECT_EQ(plan.methods, small_plan().methods);
  EXPECT_EQ(plan.score.window, 7.0);
  EXPECT_EQ(plan.score.ospa.cutoff, 20.0);
  EXPECT_NE(testing::error_of([] { plan_of({}); }).find("is of no comparison"), std::string::npos);
}

}  // namespace
}  // namespace lookout::tools
