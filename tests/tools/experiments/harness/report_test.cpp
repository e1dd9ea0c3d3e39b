#include "tools/experiments/harness/report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/temporary_directory.hpp"
#include "tests/tools/experiments/harness/dice_experiment.hpp"

namespace lookout::tools {
namespace {

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(Report, WritesTheContractsFields) {
  const tests::TemporaryDirectory folder;
  const DiceExperiment dice;
  MonteCarloOptions options;
  options.runs = 20;
  options.seed = 9;
  write_results(dice, run_monte_carlo(dice, "dice", options), folder.path());

  const auto json = nlohmann::json::parse(text_of(folder.file("results.json")));
  EXPECT_EQ(json["experiment"], "dice");
  EXPECT_EQ(json["seed"], 9);
  EXPECT_EQ(json["runs"], 20);
  EXPECT_EQ(json["cells"][0]["method"], "die");
  EXPECT_EQ(json["cells"][0]["parameters"]["sides"], 6.0);
  EXPECT_EQ(json["cells"][0]["parameters"]["colour"], "red");
  EXPECT_EQ(json["cells"][0]["paper"]["eyes"], 3.5);
  EXPECT_TRUE(json["cells"][0]["metrics"]["eyes"]["ci95"].is_number());
  EXPECT_TRUE(text_of(folder.file("results.csv"))
                  .starts_with("method,sides,colour,metric,mean,ci95,runs,paper\ndie,6,red,"));
  EXPECT_NE(text_of(folder.file("report.md")).find("seed 9, 20 runs"), std::string::npos);
}

}  // namespace
}  // namespace lookout::tools
