#include "tools/watch/heard.hpp"

#include <gtest/gtest.h>

#include "core/input_error.hpp"
#include "lcmtypes/bus.hpp"
#include "tests/tools/watch/watch_examples.hpp"
#include "tools/watch/listen.hpp"

namespace lookout::tools {
namespace {

TEST(Heard, PlacesAScanOnceTheStateAfterItIsThere) {
  Heard heard("");
  say(heard, "VEHICLE_STATE", lcmtypes::to_wire(core::VehicleState{1'500'000, {0.0, 10.0, 0.0}, {0, 0}}));
  say(heard, "SONAR_SCAN",
      lcmtypes::to_wire(tests::example_scan()));  // At 2 s, mounted 1.5 m ahead, 0.5 m to port.
  EXPECT_FALSE(heard.newest().scan);
  say(heard, "VEHICLE_STATE", lcmtypes::to_wire(core::VehicleState{2'500'000, {2.0, 10.0, 0.0}, {0, 0}}));
  ASSERT_TRUE(heard.newest().scan);
  const auto pose = heard.newest().scan->T_earth_sonar;
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->north, 1.0 + 1.5, 1e-12);  // Half way between 0 and 2 m, and the mount.
  EXPECT_NEAR(pose->east, 10.0 - 0.5, 1e-12);
}

TEST(Heard, ShowsAScanWithoutPoseWhenTheNextComes) {
  Heard heard("");
  core::SonarScan scan = tests::example_scan();
  say(heard, "SONAR_SCAN", lcmtypes::to_wire(scan));
  ++scan.sequence;
  say(heard, "SONAR_SCAN", lcmtypes::to_wire(scan));
  ASSERT_TRUE(heard.newest().scan);
  EXPECT_EQ(heard.newest().scan->ping.sequence, scan.sequence - 1);
  EXPECT_FALSE(heard.newest().scan->T_earth_sonar);
}

TEST(Heard, TellsWhatIsNewAndCountsWhatIsDamaged) {
  std::vector<Topic> news;
  Heard heard("AUV1_", [&news](Topic topic) { news.push_back(topic); });
  say(heard, "AUV1_GROUND_TRUTH", lcmtypes::to_wire(tests::example_truth()));
  say(heard, "GROUND_TRUTH", lcmtypes::to_wire(tests::example_truth()));
  heard.take("AUV1_LOOKOUT_STATUS", std::vector<std::uint8_t>(30, 0), at_second(0.0));
  EXPECT_EQ(news, std::vector<Topic>{Topic::truth});
  EXPECT_EQ(heard.channel(Topic::status).counts.undecodable, 1);
}

TEST(Heard, KeepsDecisionsAndCountsDamagedOnes) {
  std::vector<Topic> news;
  Heard heard("", [&news](Topic topic) { news.push_back(topic); });
  say(heard, "DECISIONS", lcmtypes::to_wire(lcmtypes::DecisionReport{5, 6, 7, "1 s track 3: confirmed\n"}));
  heard.take("DECISIONS", std::vector<std::uint8_t>(30, 0), at_second(0.0));
  EXPECT_EQ(news, std::vector<Topic>{Topic::decisions});
  ASSERT_TRUE(heard.newest().decisions);
  EXPECT_EQ(heard.newest().decisions->source_id, 7);
  const auto counts = heard.channel(Topic::decisions).counts;
  EXPECT_EQ(counts.received, 2);
  EXPECT_EQ(counts.undecodable, 1);
  EXPECT_EQ(heard.inbox().bad_messages(), 1);
  EXPECT_EQ(heard.inbox().last_error(), "DECISIONS: not one whole message of its type");
}

TEST(Heard, KeepsTheNewestClutterMapWhichHasNoLosses) {
  Heard heard("");
  core::ClutterGrid grid = tests::example_clutter_grid();
  say(heard, "CLUTTER_MAP", lcmtypes::to_wire(grid));
  grid.utime += 60'000'000;
  say(heard, "CLUTTER_MAP", lcmtypes::to_wire(grid));
  ASSERT_TRUE(heard.newest().clutter);
  EXPECT_EQ(heard.newest().clutter->utime, grid.utime);
  EXPECT_EQ(heard.channel(Topic::clutter).counts.lost, 0);
}

TEST(Heard, KeepsNoMoreNodesThanItsBound) {
  Heard heard("");
  for (int id = 1; id < 100; ++id) {
    node_status_t status = tracker_status();
    status.node_id = id;
    say(heard, "LOOKOUT_STATUS", status);
  }
  EXPECT_EQ(heard.newest().nodes.size(), Heard::kMaxNodes);
}

TEST(Heard, RefusesABadPrefix) {
  EXPECT_THROW(Heard("a b"), core::InputError);
}

TEST(Listen, HearsABus) {
  lcmtypes::Bus bus("memq://");
  Heard heard("");
  listen(bus, heard);
  bus.publish("VEHICLE_STATE", lcmtypes::to_wire(tests::example_state()));
  bus.drain();
  ASSERT_TRUE(heard.newest().vehicle);
  EXPECT_EQ(heard.newest().vehicle->utime, tests::example_state().utime);
}

}  // namespace
}  // namespace lookout::tools
