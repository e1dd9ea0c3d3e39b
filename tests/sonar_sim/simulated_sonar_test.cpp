#include "sonar_sim/simulated_sonar.hpp"

#include <gtest/gtest.h>

namespace lookout::sonar_sim {
namespace {

/// A scene of one target 60 m ahead, echoed always, without false alarms unless `keys` says otherwise.
Scene scene_with(const std::string& keys, const std::string& sea = "{}") {
  return parse_scene("duration: 50\nsonar: {miss_probability: 0, echo_range_sigma: 0, " + keys +
                         "}\nsea: " + sea + "\ntargets: [{id: 1, north: 60, east: 0.5}]\n",
                     "scene.yaml");
}

/// All scans that leave the sonar, which stands at the origin.
std::vector<core::SonarScan> scans_of(const Scene& scene, std::uint64_t seed = 1) {
  SimulatedSonar sonar(scene.platforms[0].sonar, scene, {seed, 0, 0, 0}, 1);
  const VehicleMotion motion(scene.platforms[0].vehicle);
  std::vector<core::SonarScan> scans;
  while (!sonar.over()) {
    const auto truth = truth_at(scene, scene.platforms[0], motion, sonar.next_time());
    if (auto scan = sonar.ping(truth, {})) scans.push_back(std::move(*scan));
  }
  return scans;
}

const std::string kQuiet = "false_alarm_probability: 0";

TEST(SimulatedSonar, ATargetsOwnEchoComesBeforeSpillAndBottom) {
  for (const auto& scan :
       scans_of(scene_with(kQuiet, "{spill: {probabilities: [1]}, bottom: {probability: 1}}"))) {
    ASSERT_EQ(scan.returns.size(), 90u);
    EXPECT_NEAR(scan.returns[45].range, 60.0, 0.01);
    EXPECT_NEAR(scan.returns[44].range, 60.0, 6.0);  // spilled, sigma 1 m
    EXPECT_GT(scan.returns[43].range, 80.0);
  }
}

TEST(SimulatedSonar, NearestHidesWhatLiesBehind) {
  const std::string wall =
      "{standing: {lines: [{from: [30, -9], to: [30, 9], probability: 1, range_sigma: 0}]}}";
  EXPECT_NEAR(scans_of(scene_with(kQuiet, wall))[0].returns[17].range, 60.0, 0.01);
  const auto nearest = scans_of(scene_with(kQuiet + ", keep: nearest", wall));
  for (const auto& one : nearest[0].returns) EXPECT_NEAR(one.range * std::cos(one.bearing), 30.0, 0.01);
}

TEST(SimulatedSonar, ReportsSeveralReturnsABeam) {
  const auto scans = scans_of(scene_with("false_alarm_probability: 1, returns_per_beam: 3"));
  ASSERT_EQ(scans[0].returns.size(), 270u);
  for (std::size_t i = 1; i < 270; ++i) {
    const auto &a = scans[0].returns[i - 1], &b = scans[0].returns[i];
    EXPECT_TRUE(a.bearing < b.bearing || (a.bearing == b.bearing && a.range < b.range));
  }
}

TEST(SimulatedSonar, UnevenBeamsReportTheirOwnBearings) {
  const auto scans = scans_of(scene_with(kQuiet + ", beam_bearings_deg: [-20, -3, 1, 10]"));
  EXPECT_EQ(scans[0].num_beams, 4);
  EXPECT_NEAR(scans[0].bearing_step, core::radians(10.0), 1e-12);
  ASSERT_EQ(scans[0].returns.size(), 1u);
  EXPECT_DOUBLE_EQ(scans[0].returns[0].bearing, core::radians(1.0));
}

TEST(SimulatedSonar, ARangeSettingHoldsFromItsTime) {
  const std::string settings = ", range_settings: [{time: 10, max_range: 50}, {time: 20, max_range: 80}]";
  for (const auto& scan : scans_of(scene_with("false_alarm_probability: 1" + settings))) {
    const double time = core::seconds(scan.utime);
    EXPECT_EQ(scan.max_range, time < 10.0 ? 150.0 : time < 20.0 ? 50.0 : 80.0);
    for (const auto& one : scan.returns) ASSERT_LE(one.range, scan.max_range);
  }
}

TEST(SimulatedSonar, EmptyAndLostScans) {
  const auto scans = scans_of(scene_with(kQuiet, "{scan_loss: {empty: 0.3, lost: 0.2}}"));
  double empty = 0.0;
  for (const auto& scan : scans) empty += scan.returns.empty() ? 1.0 : 0.0;
  EXPECT_NEAR(static_cast<double>(scans.size()), 80.0, 5.0 * std::sqrt(100 * 0.8 * 0.2));
  EXPECT_NEAR(empty, 24.0, 5.0 * std::sqrt(100 * 0.24 * 0.76));
  EXPECT_GT(scans.back().sequence, static_cast<std::int64_t>(scans.size()) - 1);  // gaps
}

TEST(SimulatedSonar, EveryReturnOfAFluctuatingSeaHasAnIntensityOfItsOwn) {
  const auto scans =
      scans_of(scene_with("false_alarm_probability: 0.3", "{fluctuation: {threshold: 1}, bottom: {}}"));
  for (const auto& one : scans[0].returns) {
    EXPECT_GE(one.intensity, 1.0 - 1e-12);
    EXPECT_NE(one.intensity, 1.0);
  }
}

TEST(SimulatedSonar, APointSensorHearsTheSeaToo) {
  const std::string sea =
      "{bottom: {probability: 1, range_sigma: 0}, bursts: [{start: 0, duration: 50, factor: 10}]}";
  const auto scans = scans_of(scene_with("clutter_per_scan: 2", sea));
  double number = 0.0;
  for (const auto& scan : scans) number += static_cast<double>(scan.returns.size());
  // The target, 90 of the bottom and a Poisson number of mean 20 in each of 100 scans.
  EXPECT_NEAR(number / 100.0, 111.0, 5.0 * std::sqrt(20.0 / 100.0));
}

TEST(SimulatedSonar, ServesAnyPeriodFromMillisecondsToAMinute) {
  for (const char* period : {"0.02", "60"}) {
    const Scene scene = scene_with(kQuiet + ", scan_period: " + period);
    EXPECT_EQ(scans_of(scene).size(), std::string(period) == "60" ? 1u : 2500u);
  }
}

}  // namespace
}  // namespace lookout::sonar_sim
