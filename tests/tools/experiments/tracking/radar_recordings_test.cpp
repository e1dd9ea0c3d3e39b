#include "tools/experiments/tracking/radar_recordings.hpp"

#include <gtest/gtest.h>

#include "tools/cli/configuration.hpp"
#include "tools/cli/paths.hpp"

namespace lookout::tools {
namespace {

/// One target at 50 m north of the sonar, heard in the scans that are true.
std::vector<TimedScan> scans_heard(const std::vector<bool>& heard) {
  std::vector<TimedScan> scans;
  for (const bool is_heard : heard) {
    TimedScan scan;
    core::TargetTruth target;
    target.id = 1;
    target.position = {50.0, 0.0};
    scan.truth.targets.push_back(target);
    scan.posed.scan.returns.push_back({0.0, 100.0});  // clutter
    if (is_heard) scan.posed.scan.returns.push_back({0.1, 55.0});
    scans.push_back(scan);
  }
  return scans;
}

std::vector<bool> in_sight(std::vector<TimedScan> scans) {
  mark_in_sight(scans);
  std::vector<bool> visible;
  for (const auto& scan : scans) visible.push_back(scan.truth.targets[0].visible);
  return visible;
}

TEST(Recordings, InSightFromTheFirstToTheLastStretchOfFiveWithThree) {
  // The stretches that begin at scans 1 (three heard) and 7 (three heard) are the outermost.
  const auto scans = scans_heard({0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0});
  EXPECT_EQ(in_sight(scans), (std::vector<bool>{0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0}));
}

TEST(Recordings, NeverInSightWhereItIsHardlyHeard) {
  const auto visible = in_sight(scans_heard({1, 0, 0, 1, 0, 0, 1, 0, 0}));
  EXPECT_EQ(std::count(visible.begin(), visible.end(), true), 0);
}

// One turn of the antenna takes 1.68 s, see the data's README; a scan is stamped after it.
TEST(Recordings, TheRadarsConfigurationStatesItsLatency) {
  Options options;
  options.config = tools_directory() + "/data/autoferry_radar.yaml";
  EXPECT_NEAR(load_configuration(options).sensor.latency, 1.68, 0.4);
}

TEST(Recordings, RunsWhereTheDataAre) {
  const auto experiment = make_recordings();
  if (!experiment->missing_input().empty()) GTEST_SKIP() << experiment->missing_input();
  for (const auto& cell : experiment->cells()) {
    if (cell.method != "gnn" || cell.parameters.number("scenario") != 16.0) continue;
    const Metrics metrics = experiment->run(cell, 1, 0);
    EXPECT_GT(metrics.at("followed_share_target1").value,
              0.5);  // the easiest of the four, see the data's README
    EXPECT_GT(metrics.at("mean_tracks").value, 1.0);
  }
}

}  // namespace
}  // namespace lookout::tools
