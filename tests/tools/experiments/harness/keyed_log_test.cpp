#include "tools/experiments/harness/keyed_log.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/files/text_file.hpp"
#include "core/input_error.hpp"
#include "tests/support/reading.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/tools/experiments/harness/dice_experiment.hpp"
#include "tools/cli/version.hpp"
#include "tools/experiments/harness/monte_carlo.hpp"

namespace lookout::tools {
namespace {

Study study_with(std::uint64_t seed) {
  return {"dice", "lookout experiment dice", seed, 20, version(), {}, {}};
}

TEST(KeyedLog, FindsTheLineOfAKey) {
  const tests::TemporaryDirectory folder;
  KeyedLog log(folder.file("runs.jsonl"), study_with(3), {}, false);
  log.append("a", R"({"key":"a","x":1})");
  log.append("b", R"({"key":"b","x":2})");
  EXPECT_EQ(log.find("a"), R"({"key":"a","x":1})");
  EXPECT_FALSE(log.find("c"));
}

TEST(KeyedLog, GoesOnForMoreRunsButNotForAnotherSeedCommitInputOrShard) {
  const tests::TemporaryDirectory folder;
  const std::string path = folder.file("runs.jsonl");
  KeyedLog(path, study_with(3), {1, 2}, false).append("a", R"({"key":"a"})");
  Study more = study_with(3);
  more.runs = 40;
  EXPECT_TRUE(KeyedLog(path, more, {1, 2}, true).has("a"));
  Study other_commit = study_with(3), other_input = study_with(3);
  other_commit.commit = "another";
  other_input.inputs["scene.yaml"] = "00";
  for (const Study& other : {study_with(4), other_commit, other_input})
    EXPECT_THROW(KeyedLog(path, other, {1, 2}, true), core::InputError);
  EXPECT_THROW(KeyedLog(path, study_with(3), {2, 2}, true), core::InputError);
  EXPECT_TRUE(KeyedLog(path, study_with(3), {1, 2}, true).has("a"));  // the refusals left it as it was
}

/// Rolls the dice in `count` shards, each in a folder of its own.
std::vector<std::string> roll_shards(const tests::TemporaryDirectory& folder, int count,
                                     std::uint64_t seed = 1) {
  std::vector<std::string> directories;
  for (int k = 1; k <= count; ++k) {
    directories.push_back(folder.file("shard" + std::to_string(k)));
    std::filesystem::create_directory(directories.back());
    MonteCarloOptions options;
    options.runs = 7;
    options.seed = seed;
    options.shard = {k, count};
    options.progress_file = directories.back() + kLogName;
    run_monte_carlo(DiceExperiment(), "dice", options);
  }
  return directories;
}

/// What `merge` of these says; "no error" where it accepts them.
std::string complaint(const std::vector<std::string>& directories, const std::string& out) {
  return testing::error_of([&] { merge_logs(directories, out); });
}

TEST(MergeLogs, ShardsGiveWhatOneMachineGives) {
  MonteCarloOptions alone;
  alone.runs = 7;
  const auto whole = run_monte_carlo(DiceExperiment(), "dice", alone);
  for (const int count : {1, 4, 12}) {
    const tests::TemporaryDirectory folder;
    auto directories = roll_shards(folder, count);
    std::reverse(directories.begin(), directories.end());
    merge_logs(directories, folder.file("all"));
    MonteCarloOptions options = alone;
    options.progress_file = folder.file("all") + kLogName;
    options.resume = true;
    const auto merged = run_monte_carlo(DiceExperiment(), "dice", options);
    for (std::size_t i = 0; i < whole.cells.size(); ++i) {
      EXPECT_EQ(merged.cells[i].metrics.at("eyes").mean, whole.cells[i].metrics.at("eyes").mean);
      EXPECT_EQ(merged.cells[i].metrics.at("eyes").ci95, whole.cells[i].metrics.at("eyes").ci95);
    }
  }
}

TEST(MergeLogs, NamesTheShardsThatMiss) {
  const tests::TemporaryDirectory folder;
  auto directories = roll_shards(folder, 4);
  directories.erase(directories.begin() + 1, directories.begin() + 3);
  EXPECT_NE(complaint(directories, folder.file("all")).find("of 4 shards these are missing: 2 3"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.file("all")));
}

TEST(MergeLogs, RefusesShardsOfAnotherSeedAndTwiceTheSame) {
  const tests::TemporaryDirectory folder, other;
  auto directories = roll_shards(folder, 2);
  const auto foreign = roll_shards(other, 2, 9);
  EXPECT_NE(complaint({directories[0], foreign[1]}, folder.file("all")).find("of another seed"),
            std::string::npos);
  directories.push_back(directories[0]);
  EXPECT_NE(complaint(directories, folder.file("all")).find("holds shard 1/2, and so does"),
            std::string::npos);
}

TEST(MergeLogs, RefusesAnUnfinishedShard) {
  const tests::TemporaryDirectory folder;
  const auto directories = roll_shards(folder, 2);
  const std::string path = directories[1] + kLogName;
  const std::string text = core::read_text_file(path, "a log");
  std::ofstream(path) << text.substr(0, text.size() - 20);  // stopped in its last lines
  EXPECT_NE(complaint(directories, folder.file("all")).find("shard 2/2 is not finished"), std::string::npos);
}

TEST(MergeLogs, RefusesPartsOfAnotherCommit) {
  const tests::TemporaryDirectory folder;
  std::filesystem::create_directory(folder.file("a"));
  Study study = study_with(1);
  study.commit = "another";
  KeyedLog(folder.file("a") + kLogName, study, {}, false).end();
  EXPECT_NE(complaint({folder.file("a")}, folder.file("all")).find("are of commit another"),
            std::string::npos);
}

TEST(MergeLogs, RefusesAShardAsItsOutput) {
  const tests::TemporaryDirectory folder;
  const auto directories = roll_shards(folder, 2);
  EXPECT_TRUE(complaint(directories, directories[0]).starts_with("--out: "));
}

}  // namespace
}  // namespace lookout::tools
