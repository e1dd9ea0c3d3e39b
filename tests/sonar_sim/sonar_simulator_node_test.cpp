#include "sonar_sim/sonar_simulator_node.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/input_error.hpp"

namespace lookout::sonar_sim {
namespace {

Scene small_scene(const std::string& vehicles) {
  return parse_scene("duration: 2.0\n" + vehicles + "targets: [{id: 1, north: 50.0, east: 0.0}]\n", "small");
}

const std::string kSonar =
    "{num_beams: 9, first_bearing_deg: -4, bearing_step_deg: 1, max_range: 100.0, scan_period: 0.5, "
    "range_sigma: 3.0, "
    "miss_probability: 0.0, false_alarm_probability: 0.0, clutter: literal}";
const std::string kOneVehicle =
    "vehicle: {north: 0.0, east: 0.0, north_velocity: 1.0}\nsonar: " + kSonar + "\n";

/// What was heard, in order: a letter for each message.
class Heard {
 public:
  Heard(lcmtypes::Bus& bus, const std::string& prefix) {
    const lcmtypes::Channels channels(prefix);
    bus.subscribe<vehicle_state_t>(channels.vehicle_state(), [this](const auto&) { order += 'v'; });
    bus.subscribe<ground_truth_t>(channels.ground_truth(), [this](const auto&) { order += 'g'; });
    bus.subscribe<sonar_scan_t>(channels.sonar_scan(), [this](const core::SonarScan& scan) {
      order += 's';
      scans.push_back(scan);
    });
  }
  std::string order;
  std::vector<core::SonarScan> scans;
};

SimulatorNodeParams full_speed() {
  SimulatorNodeParams params;
  params.speed.reset();
  params.wait_for_tracks = false;
  return params;
}

TEST(SonarSimulatorNode, SurroundsEachScanByVehicleStates) {
  lcmtypes::Bus bus("memq://");
  Heard heard(bus, "");
  SimulatorNodeParams params = full_speed();
  params.start_utime = 7'000'000;
  const auto figures = SonarSimulatorNode(bus, small_scene(kOneVehicle), params).run({});
  bus.drain();
  EXPECT_EQ(heard.order, "vgsvvgsvvgsvvgsv");
  EXPECT_EQ(figures.scans, 4);
  EXPECT_TRUE(figures.complete);
  ASSERT_EQ(heard.scans.size(), 4u);
  EXPECT_EQ(heard.scans[1].utime, 7'500'000);
  EXPECT_EQ(heard.scans[1].sequence, 1);
}

TEST(SonarSimulatorNode, SendsTheSonarsOfOneVehicleOnItsChannels) {
  lcmtypes::Bus bus("memq://");
  Heard heard(bus, "");
  const Scene scene = small_scene("sonars: [" + kSonar + ", " + kSonar + "]\n");
  const auto figures = SonarSimulatorNode(bus, scene, full_speed()).run({});
  bus.drain();
  EXPECT_EQ(heard.order, "vgssvvgssvvgssvvgssv");  // one truth for both
  EXPECT_EQ(figures.scans, 8);
  EXPECT_EQ(heard.scans[0].sensor_id, 1);
  EXPECT_EQ(heard.scans[1].sensor_id, 2);
  EXPECT_EQ(heard.scans[3].sequence, 1);
}

TEST(SonarSimulatorNode, SendsSeveralVehiclesUnderTheirPrefixesInOrderOfTime) {
  lcmtypes::Bus bus("memq://");
  Heard first(bus, "X_A_"), second(bus, "X_B_");
  const std::string vehicles =
      "vehicles:\n  - {channel_prefix: A_, node_id: 1, vehicle: {north: 0.0, east: 0.0}, sonar: " + kSonar +
      "}\n  - {channel_prefix: B_, node_id: 2, vehicle: {north: 9.0, east: 0.0}, sonar: " + kSonar + "}\n";
  SimulatorNodeParams params = full_speed();
  params.channel_prefix = "X_";
  EXPECT_EQ(SonarSimulatorNode(bus, small_scene(vehicles), params).run({}).scans, 8);
  bus.drain();
  EXPECT_EQ(first.scans.size(), 4u);
  EXPECT_EQ(second.scans.size(), 4u);
}

TEST(SonarSimulatorNode, KeepsTimeAtSpeedTwenty) {
  lcmtypes::Bus bus("memq://");
  SimulatorNodeParams params;
  params.speed = 20.0;
  const auto begin = lcmtypes::NodeLoop::Clock::now();
  SonarSimulatorNode(bus, small_scene(kOneVehicle), params).run({});
  // The last scan is at 1.5 s: 75 ms of wall time.
  EXPECT_GE(lcmtypes::NodeLoop::Clock::now() - begin, std::chrono::milliseconds(75));
}

TEST(SonarSimulatorNode, AtFullSpeedWaitsForTracksAndCountsThoseThatDoNotCome) {
  lcmtypes::Bus bus("memq://");
  // A tracker that answers all scans but the second.
  bus.subscribe<sonar_scan_t>("SONAR_SCAN", [&bus](const core::SonarScan& scan) {
    if (scan.sequence != 1)
      bus.publish("TRACKS", lcmtypes::to_wire({scan.utime, scan.sequence, scan.sensor_id},
                                              std::span<const core::Track>())
                                .message);
  });
  SimulatorNodeParams params;
  params.speed.reset();
  params.answer_wait = 0.2;
  const auto begin = lcmtypes::NodeLoop::Clock::now();
  const auto figures = SonarSimulatorNode(bus, small_scene(kOneVehicle), params).run({});
  EXPECT_GE(lcmtypes::NodeLoop::Clock::now() - begin, std::chrono::milliseconds(200));
  EXPECT_EQ(figures.scans, 4);
  EXPECT_EQ(figures.unanswered, 1);
}

TEST(SonarSimulatorNode, WaitsForNodesOtherThanItsOwnKind) {
  lcmtypes::Bus bus("memq://");
  SimulatorNodeParams params = full_speed();
  params.wait_for = 1;
  SonarSimulatorNode node(bus, small_scene(kOneVehicle), params);
  lcmtypes::StatusBoard(bus, "LOOKOUT_STATUS", "lookout score", 0).publish({}, "");
  EXPECT_EQ(node.run({.duration = 0.1}).scans, 0);
  lcmtypes::StatusBoard(bus, "LOOKOUT_STATUS", "lookout track", 5).publish({}, "");
  EXPECT_EQ(node.run({.duration = 10.0}).scans, 4);
}

TEST(SonarSimulatorNode, RefusesParamsOutOfRange) {
  lcmtypes::Bus bus("memq://");
  const Scene scene = small_scene(kOneVehicle);
  SimulatorNodeParams params;
  params.speed = 0.0;
  EXPECT_THROW(SonarSimulatorNode(bus, scene, params), core::InputError);
  params = {};
  params.wait_for = -1;
  EXPECT_THROW(SonarSimulatorNode(bus, scene, params), core::InputError);
  for (const double wait : {0.0, -1.0, 2e6, std::nan("")}) {
    params = {};
    params.answer_wait = wait;
    EXPECT_THROW(SonarSimulatorNode(bus, scene, params), core::InputError) << wait;
  }
  params = {};
  params.channel_prefix = "*";
  EXPECT_THROW(SonarSimulatorNode(bus, scene, params), core::InputError);
}

}  // namespace
}  // namespace lookout::sonar_sim
