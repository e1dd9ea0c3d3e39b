#include "tools/experiments/tracking/scored_run.hpp"

#include <gtest/gtest.h>

#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

std::vector<TimedScan> easy_run() {
  return simulate(load_variant("tracking_table7.yaml", {0.1, 0.1, 1.0, sonar_sim::ClutterReading::light}),
                  1000, 0);
}

TEST(ScoredRun, OneAnswerAScanAndItsMetrics) {
  const auto scans = easy_run();
  const auto tracker = pipeline_of("gnn", {}, 1);
  const auto output = track(*tracker, scans);
  ASSERT_EQ(output.tracks.size(), scans.size());
  const Metrics metrics = score(scans, output);
  EXPECT_LT(metrics.at("ospa").value, 5.0);  // 20 where nothing is reported, [Yan2018] tables 2 to 7
  EXPECT_GT(metrics.at("followed_share").value, 0.8);
  EXPECT_GE(metrics.at("ospa_schedule").value, 0.0);
}

TEST(ScoredRun, RunsDrawFromSeedsOfTheirOwn) {
  EXPECT_EQ(run_seed(1, 5), run_seed(1, 5));
  EXPECT_NE(run_seed(1, 5), run_seed(1, 6));
  EXPECT_NE(run_seed(1, 5), run_seed(2, 5));
}

TEST(ScoredRun, DelayedOutputAnswersForScansThatAreLongEnoughAgo) {
  const auto scans = easy_run();
  const auto scene = load_variant("tracking_table7.yaml", {0.1, 0.1, 1.0, sonar_sim::ClutterReading::light});
  const core::SonarParams sonar = sonar_sim::known_params(scene, scene.platforms[0]);
  const auto online = pipeline_of("joint", sonar, 1);
  const auto delayed = pipeline_of("joint", sonar, 1);
  const auto late = track(*delayed, scans, 5.0);
  EXPECT_EQ(late.tracks.size(), scans.size() - 10);  // 5 s of two scans a second
  EXPECT_LT(score(scans, late).at("ospa").value, score(scans, track(*online, scans)).at("ospa").value);
}

}  // namespace
}  // namespace lookout::tools
