#include "tools/experiments/harness/report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/temporary_directory.hpp"
#include "tests/tools/experiments/harness/dice_experiment.hpp"
#include "tools/cli/version.hpp"

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
  ExperimentResults results = run_monte_carlo(dice, "dice", options);
  results.command = "lookout experiment dice --runs 20 --seed 9 --only sides=6 --out there";
  write_results(dice, results, folder.path());

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
  EXPECT_EQ(json["command"], results.command);
  EXPECT_EQ(json["commit"], version());
  const std::string report = text_of(folder.file("report.md"));
  EXPECT_NE(report.find("seed 9, 20 runs"), std::string::npos);
  EXPECT_NE(report.find("\n    " + results.command + " --out "), std::string::npos);
  EXPECT_NE(report.find("\nCommit: " + version() + "\n"), std::string::npos);
}

}  // namespace
}  // namespace lookout::tools
