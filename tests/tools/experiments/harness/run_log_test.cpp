#include "tools/experiments/harness/run_log.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/tools/experiments/harness/dice_experiment.hpp"

namespace lookout::tools {
namespace {

Study dice(std::uint64_t seed) {
  return {"dice", "", seed, 10, "", {}, {}};
}

TEST(RunLog, ResumesWhatItWroteAndSurvivesAHalfLine) {
  const tests::TemporaryDirectory folder;
  const std::string path = folder.file("runs.jsonl");
  const auto cells = DiceExperiment().cells();
  {
    RunLog log(path, dice(3), {}, false);
    log.append(cells[0], 7, {{"eyes", Metric(1.0 / 3.0, 2.0)}});
  }
  std::ofstream(path, std::ios::app) << "{\"key\": \"die si";
  const RunLog log(path, dice(3), {}, true);
  const auto metrics = log.find(cells[0], 7);
  ASSERT_TRUE(metrics);
  EXPECT_EQ(metrics->at("eyes").value, 1.0 / 3.0);
  EXPECT_EQ(metrics->at("eyes").weight, 2.0);
  EXPECT_FALSE(log.find(cells[0], 8));
  EXPECT_FALSE(log.find(cells[1], 7));
}

TEST(RunLog, LinesOfAnotherShapeAreRunsToDoAgain) {
  const tests::TemporaryDirectory folder;
  const std::string path = folder.file("runs.jsonl");
  const auto cells = DiceExperiment().cells();
  RunLog(path, dice(3), {}, false).append(cells[0], 0, {{"eyes", 1.0}});
  std::ofstream(path, std::ios::app) << "3\n[]\n{\"key\": 3}\n{\"key\": \"a\", \"metrics\": [1]}\n"
                                        "{\"key\": \"a\", \"metrics\": {\"m\": 1}}\n\n";
  EXPECT_TRUE(RunLog(path, dice(3), {}, true).find(cells[0], 0));
  std::ofstream(path) << "[1, 2]\n";
  EXPECT_THROW(RunLog(path, dice(3), {}, true), core::InputError);
}

TEST(RunLog, RefusesAnotherSeedAndForgetsWithoutResume) {
  const tests::TemporaryDirectory folder;
  const std::string path = folder.file("runs.jsonl");
  const auto cells = DiceExperiment().cells();
  RunLog(path, dice(3), {}, false).append(cells[0], 0, {{"eyes", 1.0}});
  EXPECT_THROW(RunLog(path, dice(4), {}, true), core::InputError);
  EXPECT_FALSE(RunLog(path, dice(3), {}, false).find(cells[0], 0));
}

}  // namespace
}  // namespace lookout::tools
