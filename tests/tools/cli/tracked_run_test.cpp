#include "tools/cli/tracked_run.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/files/csv.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tools {
namespace {

/// One target at (3, 4) m at two times; a track at the origin at the first, none at the second.
TrackedRun half_missed() {
  TrackedRun run;
  for (const std::int64_t utime : {0, 500'000}) {
    core::GroundTruth truth{utime, {}};
    truth.targets.push_back({1, {3.0, 4.0}, {0.0, 0.0}, true});
    run.recording.truth.push_back(truth);
    run.recording.scans.emplace_back();
    run.output.tracks.push_back({utime, {}});
    run.output.elements.push_back({utime, {}});
  }
  core::Track track;
  track.status = core::TrackStatus::confirmed;
  run.output.tracks[0].tracks.push_back(track);
  return run;
}

TEST(WriteTrackedRun, ScoresEveryScanAndSumsUp) {
  const tests::TemporaryDirectory folder;
  Options options;
  options.inputs = {"scene.yaml"};
  write_tracked_run(folder.path(), half_missed(), {}, options);
  constexpr std::array<std::string_view, 6> kColumns{"time_s",      "total",     "localization",
                                                     "cardinality", "num_truth", "num_tracks"};
  const core::CsvTable table(folder.file("ospa.csv"), kColumns);
  ASSERT_EQ(table.num_rows(), 2u);
  EXPECT_EQ(table.number(0, "total"), 5.0);         // the distance
  EXPECT_EQ(table.number(1, "cardinality"), 20.0);  // the cut-off
  std::ifstream file(folder.file("summary.json"));
  const auto summary = nlohmann::json::parse(file);
  EXPECT_EQ(summary["ospa"]["total"], 12.5);
  EXPECT_EQ(summary["tracked_scans"], 2);
  EXPECT_EQ(summary["scenario"], "scene.yaml");
}

TEST(WriteTrackedRun, AScanThatWasRefusedIsScoredWithoutTracks) {
  const tests::TemporaryDirectory folder;
  Options options;
  options.inputs = {"scene.yaml"};
  TrackedRun run = half_missed();
  run.recording.scans[1].utime = 500'000;
  run.output.tracks.pop_back();
  write_tracked_run(folder.path(), run, {}, options);
  std::ifstream file(folder.file("summary.json"));
  const auto summary = nlohmann::json::parse(file);
  EXPECT_EQ(summary["ospa"]["total"], 12.5);  // As above: (5 + 20) / 2.
  EXPECT_EQ(summary["ospa"]["times"], 2);
}

TEST(WriteTrackedRun, ASummaryOfTrackedImagesCountsThemAndNamesTheirTracker) {
  const tests::TemporaryDirectory folder;
  Options options;
  options.inputs = {"log"};
  options.estimator = "h_pmht";
  TrackedRun run = half_missed();
  run.recording.scans.clear();
  run.counts.accepted = 2;
  write_tracked_run(folder.path(), run, load_configuration(options), options);
  std::ifstream file(folder.file("summary.json"));
  const auto summary = nlohmann::json::parse(file);
  EXPECT_EQ(summary["tracker"], "h_pmht");
  EXPECT_EQ(summary["scans"], 2);
}

TEST(WriteTrackedRun, WithoutTruthThereIsNoScore) {
  const tests::TemporaryDirectory folder;
  Options options;
  options.inputs = {"recording"};
  TrackedRun run = half_missed();
  run.recording.truth.clear();
  write_tracked_run(folder.path(), run, {}, options);
  EXPECT_FALSE(std::ifstream(folder.file("ospa.csv")).good());
  std::ifstream file(folder.file("summary.json"));
  EXPECT_FALSE(nlohmann::json::parse(file).contains("ospa"));
}

}  // namespace
}  // namespace lookout::tools
