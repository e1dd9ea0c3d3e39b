#include "sonar_sim/sonar_simulator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace lookout::sonar_sim {
namespace {

const std::string kTable7 = LOOKOUT_SOURCE_DIR "/tools/scenarios/tracking_table7.yaml";

TEST(SonarSimulator, SameSeedAndRunRepeatAndOthersDiffer) {
  const Scene scene = load_scene(kTable7);
  SonarSimulator a(scene, 5, 2), b(scene, 5, 2), c(scene, 5, 3);
  const auto first = a.next()->scan.returns, same = b.next()->scan.returns, other = c.next()->scan.returns;
  ASSERT_EQ(first.size(), same.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].range, same[i].range);
  ASSERT_FALSE(other.empty());
  EXPECT_NE(first[0].range, other[0].range);
}

TEST(SonarSimulator, ScansCountFromZeroToTheEnd) {
  SonarSimulator simulator(load_scene(kTable7), 1);
  std::int64_t scans = 0;
  while (const auto simulated = simulator.next()) {
    EXPECT_EQ(simulated->scan.sequence, scans);
    EXPECT_EQ(simulated->scan.utime, 500'000 * scans);
    EXPECT_EQ(simulated->truth.utime, simulated->scan.utime);
    ++scans;
  }
  EXPECT_EQ(scans, 200);
}

TEST(SonarSimulator, InterpolatedReportsGiveTheTruePose) {
  Scene scene = load_scene(LOOKOUT_SOURCE_DIR "/tools/scenarios/turning_vehicle.yaml");
  SonarSimulator simulator(scene, 1);
  core::PoseHistory history;
  while (const auto simulated = simulator.next()) {
    for (const auto& state : simulated->states_before) history.add(state);
    for (const auto& state : simulated->states_after) history.add(state);
    const auto body = history.at(simulated->scan.utime);
    ASSERT_TRUE(body);
    const core::Pose2 sonar = core::compose(*body, simulated->scan.T_body_sonar);
    // The report pair spans a corner of the route at a waypoint, where interpolation cuts it.
    EXPECT_NEAR(sonar.north, simulated->T_earth_sonar.north, 0.08);
    EXPECT_NEAR(sonar.heading, simulated->T_earth_sonar.heading, core::radians(0.31));
  }
}

TEST(SonarSimulator, NavigationFaultsLeaveTheReturnsAlone) {
  Scene scene = load_scene(kTable7);
  SonarSimulator clean(scene, 1);
  scene.platforms[0].vehicle.navigation = {0.5, 0.02, 0.02, 0.5, 0.7};
  SonarSimulator faulty(scene, 1);
  std::size_t reports = 0;
  for (int k = 0; k < 100; ++k) {
    const auto a = clean.next(), b = faulty.next();
    ASSERT_EQ(a->scan.returns.size(), b->scan.returns.size());
    reports += b->states_before.size() + b->states_after.size();
  }
  EXPECT_NEAR(static_cast<double>(reports), 100.0, 5.0 * std::sqrt(50.0));  // half of 200 reports are lost
}

/// The times of all that a scene's vehicle sends: reports 'v' and scans by their sensor's number.
std::vector<std::pair<std::int64_t, char>> traffic_of(const std::string& text) {
  SonarSimulator simulator(parse_scene(text, "scene.yaml"), 1);
  std::vector<std::pair<std::int64_t, char>> traffic;
  while (const auto simulated = simulator.next()) {
    for (const auto& state : simulated->states_before) traffic.emplace_back(state.utime, 'v');
    traffic.emplace_back(simulated->scan.utime, static_cast<char>('0' + simulated->scan.sensor_id));
    for (const auto& state : simulated->states_after) traffic.emplace_back(state.utime, 'v');
  }
  return traffic;
}

const std::string kSonarKeys = "miss_probability: 0.1, false_alarm_probability: 0.1";

TEST(SonarSimulator, ReportsOfFastScansNeverCross) {
  for (const char* period : {"0.02", "0.05", "0.1", "0.2", "0.5", "60"}) {
    const auto traffic =
        traffic_of("duration: 120\nsonar: {" + kSonarKeys + ", scan_period: " + period + "}\n");
    std::int64_t newest = -1;
    for (const auto& [utime, kind] : traffic) {
      ASSERT_GE(utime, newest) << period;
      if (kind != 'v') continue;
      ASSERT_GT(utime, newest) << period;
      newest = utime;
    }
  }
}

TEST(SonarSimulator, SonarsOfOneVehicleShareItsReportsInOrderOfTime) {
  const auto traffic =
      traffic_of("duration: 60\nsonars:\n  - {" + kSonarKeys + "}\n  - {" + kSonarKeys +
                 ", sensor_id: 7, scan_period: 0.3, first_scan: 0.5, mount_heading_deg: 90}\n");
  std::map<char, int> count;
  std::int64_t newest_report = -1, newest_scan = -1;
  for (const auto& [utime, kind] : traffic) {
    ++count[kind];
    std::int64_t& newest = kind == 'v' ? newest_report : newest_scan;
    ASSERT_GE(utime, newest + (kind == 'v' ? 1 : 0));
    newest = utime;
  }
  EXPECT_EQ(count['1'], 120);
  EXPECT_EQ(count['7'], 199);  // .5, .8, ... 59.9 s
}

TEST(SonarSimulator, EachSonarHearsForItself) {
  const std::string two = "duration: 5\nsonars: [{" + kSonarKeys + "}, {" + kSonarKeys + "}]\n";
  SonarSimulator simulator(parse_scene(two, "scene.yaml"), 1);
  const auto first = simulator.next(), second = simulator.next();
  EXPECT_EQ(first->scan.utime, second->scan.utime);
  EXPECT_EQ(first->scan.sensor_id, 1);
  EXPECT_EQ(second->scan.sensor_id, 2);
  ASSERT_FALSE(first->scan.returns.empty());
  ASSERT_FALSE(second->scan.returns.empty());
  EXPECT_NE(first->scan.returns[0].range, second->scan.returns[0].range);
}

TEST(SonarSimulator, LostScansKeepTheirReports) {
  const auto whole = traffic_of("duration: 30\nsonar: {" + kSonarKeys + "}\n");
  const auto holed = traffic_of("duration: 30\nsonar: {" + kSonarKeys + ", sea: {scan_loss: {lost: 0.4}}}\n");
  const auto reports = [](const auto& traffic) {
    return std::count_if(traffic.begin(), traffic.end(), [](const auto& one) { return one.second == 'v'; });
  };
  EXPECT_LT(holed.size(), whole.size() - 10);
  EXPECT_GE(reports(holed), reports(whole) - 10);  // those after the last scan that was not lost are not sent
}

TEST(SonarSimulator, AHeadingBiasIsInEveryReportAndNoEcho) {
  Scene scene = load_scene(kTable7);
  SonarSimulator clean(scene, 1);
  scene.platforms[0].vehicle.navigation.drift.heading_bias = core::radians(3.0);
  SonarSimulator biased(scene, 1);
  for (int k = 0; k < 20; ++k) {
    const auto a = clean.next(), b = biased.next();
    ASSERT_EQ(a->scan.returns.size(), b->scan.returns.size());
    EXPECT_NEAR(b->states_before[0].T_earth_body.heading - a->states_before[0].T_earth_body.heading,
                core::radians(3.0), 1e-12);
    EXPECT_EQ(a->T_earth_sonar.heading, b->T_earth_sonar.heading);
  }
}

TEST(SonarSimulator, StandingThingsAreNoTruth) {
  SonarSimulator simulator(
      parse_scene("duration: 5\nsonar: {" + kSonarKeys +
                      "}\nsea: {standing: {fields: [{count: 50, north: [0, 140], east: [-70, 70]}]}}\n",
                  "scene.yaml"),
      1);
  while (const auto simulated = simulator.next()) EXPECT_TRUE(simulated->truth.targets.empty());
}

TEST(SonarSimulator, DelayedReportsArriveLater) {
  Scene scene = load_scene(kTable7);
  scene.platforms[0].vehicle.navigation.delay = 0.7;
  SonarSimulator simulator(scene, 1);
  EXPECT_TRUE(simulator.next()->states_before.empty());
  const auto second = simulator.next();  // the report of 0 s arrives at 0.7 s, after the scan at 0.5 s
  EXPECT_TRUE(second->states_before.empty());
  ASSERT_FALSE(second->states_after.empty());
  EXPECT_EQ(second->states_after[0].utime, 0);
}

}  // namespace
}  // namespace lookout::sonar_sim
