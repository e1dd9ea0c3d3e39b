#include "tools/experiments/tracking_run.hpp"

#include <gtest/gtest.h>

#include "tools/experiments/csht_tracking.hpp"
#include "tools/experiments/perfect_association.hpp"
#include "tracking/metrics/scorer.hpp"
#include "tracking/tracker_registry.hpp"

namespace lookout::tools {
namespace {

std::vector<TimedScan> easy_run() {
  return simulate(load_variant("tracking_table7.yaml", {0.1, 0.1, 1.0, sonar_sim::ClutterReading::light}),
                  1000, 0);
}

TEST(TrackingRun, OneAnswerAScanAndItsMetrics) {
  const auto scans = easy_run();
  const auto tracker = tracking::make_tracker("gnn", {}, {}, {}, 1);
  const auto output = track(*tracker, scans);
  ASSERT_EQ(output.tracks.size(), scans.size());
  const Metrics metrics = score(scans, output);
  EXPECT_LT(metrics.at("ospa").value, 5.0);  // 20 where nothing is reported, [Yan2018] tables 2 to 7
  EXPECT_GT(metrics.at("followed_share").value, 0.8);
  EXPECT_GE(metrics.at("ospa_schedule").value, 0.0);
}

TEST(TrackingRun, RunsDrawFromSeedsOfTheirOwn) {
  EXPECT_EQ(run_seed(1, 5), run_seed(1, 5));
  EXPECT_NE(run_seed(1, 5), run_seed(1, 6));
  EXPECT_NE(run_seed(1, 5), run_seed(2, 5));
}

TEST(TrackingRun, DelayedOutputAnswersForScansThatAreLongEnoughAgo) {
  const auto scans = easy_run();
  const auto scene = load_variant("tracking_table7.yaml", {0.1, 0.1, 1.0, sonar_sim::ClutterReading::light});
  const core::SonarParams sonar = sonar_sim::known_params(scene, scene.platforms[0]);
  const auto online = tracking::make_tracker("joint", {}, sonar, {}, 1);
  const auto delayed = tracking::make_tracker("joint", {}, sonar, {}, 1);
  const auto late = track(*delayed, scans, 5.0);
  EXPECT_EQ(late.tracks.size(), scans.size() - 10);  // 5 s of two scans a second
  EXPECT_LT(score(scans, late).at("ospa").value, score(scans, track(*online, scans)).at("ospa").value);
}

TEST(PerfectAssociation, IsBetterThanATracker) {
  const auto scans = easy_run();
  const core::SonarParams sonar;
  PerfectAssociation reference(sonar);
  tracking::Scorer told, found;
  const auto tracker = tracking::make_tracker("gnn", {}, sonar, {}, 1);
  for (const auto& scan : scans) {
    told.add(scan.truth, reference.update(scan));
    found.add(scan.truth, tracker->update(scan.posed));
  }
  EXPECT_LT(told.mean().position.total, found.mean().position.total);
  EXPECT_LT(told.mean().position.total, 1.0);  // sigma 1 m and the late first echo of five targets
}

TEST(PerfectAssociation, NeverReportsMoreThanIsInView) {
  PerfectAssociation reference{core::SonarParams{}};
  for (const auto& scan : easy_run()) {
    const auto in_view = std::count_if(scan.truth.targets.begin(), scan.truth.targets.end(),
                                       [](const auto& target) { return target.visible; });
    EXPECT_LE(static_cast<long>(reference.update(scan).size()), in_view);
  }
}

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

}  // namespace
}  // namespace lookout::tools
