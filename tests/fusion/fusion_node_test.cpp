#include "fusion/fusion_node.hpp"

#include <gtest/gtest.h>

#include "lcmtypes/convert_reports.hpp"
#include "tests/fusion/test_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::estimate;

/// A node, and what comes out of it, on a bus in memory.
class OnOneBus : public ::testing::Test {
 protected:
  OnOneBus() {
    bus.subscribe<track_list_t>(lcmtypes::Channels::kGlobalTracks, [this](lcmtypes::KeyedTracks tracks) {
      pictures.push_back(std::move(tracks));
    });
  }

  void send(std::int32_t node_id, double time) {
    bus.publish(lcmtypes::Channels::kLocalEstimate,
                lcmtypes::to_wire(estimate(node_id, 1, time, {2.0 * time, 0, 2, 0})));
  }

  void run() {
    lcmtypes::LoopLimits limits;
    limits.duration = 0.2;
    node.run(limits);
    bus.drain();
  }

  lcmtypes::Bus bus{"memq://"};
  FusionNode node{bus, {}};
  std::vector<lcmtypes::KeyedTracks> pictures;
};

TEST_F(OnOneBus, OnePictureForEachTimeWithBothNodesInIt) {
  for (int k = 0; k < 6; ++k) {
    send(1, 0.5 * k);
    send(2, 0.5 * k);
  }
  run();
  ASSERT_EQ(pictures.size(), 6u);
  EXPECT_EQ(pictures.back().key.utime, core::microseconds(2.5));
  EXPECT_EQ(pictures.back().key.sequence, 5);
  ASSERT_EQ(pictures.back().tracks.size(), 1u);
  EXPECT_NEAR(pictures.back().tracks[0].state(0), 5.0, 1e-6);
  EXPECT_NEAR(pictures.back().tracks[0].existence, 0.99, 1e-9);  // Both nodes: 1 - 0.1^2.
}

TEST_F(OnOneBus, DamagedMessagesAreCountedAndHarmless) {
  send(1, 0.0);
  local_estimate_t bad{};
  bad.num_covariance = 3;
  bad.covariance.resize(3);
  bus.publish(lcmtypes::Channels::kLocalEstimate, bad);
  bus.publish(lcmtypes::Channels::kLocalEstimate, track_list_t{});
  send(1, 0.5);
  send(1, 0.5);
  run();
  EXPECT_EQ(node.fusion().count(Intake::accepted), 2);
  EXPECT_EQ(node.refused(), 3);
}

TEST_F(OnOneBus, TellsOfTwoVehiclesWithOneIdAndWhatItRefused) {
  std::string said;
  bus.subscribe_bytes("LOOKOUT_STATUS", [&said](std::span<const std::uint8_t> bytes) {
    if (const auto status = lcmtypes::read_node_status(bytes)) said = status->last_error;
  });
  for (int k = 0; k < 4; ++k) {
    core::LocalEstimate here = estimate(1, 1, 0.5 * k, {0, 0, 2, 0});
    here.p_earth_node = {k % 2 == 0 ? 0.0 : 5000.0, 0.0};
    bus.publish(lcmtypes::Channels::kLocalEstimate, lcmtypes::to_wire(here));
  }
  send(1, 1.5);
  run();
  EXPECT_GE(node.leaps(), 3);
  EXPECT_NE(said.find("node 1 leaps to and fro"), std::string::npos) << said;
  EXPECT_NE(said.find("refused: 1 repeated"), std::string::npos) << said;
}

// 300 estimates of one node come before there is time for any; four of them were to wait.
TEST(FusionNode, AFloodCostsItsSenderAloneAndIsCounted) {
  lcmtypes::Bus bus("memq://");
  FusionNodeParams params;
  params.max_waiting = 4;
  FusionNode node(bus, params);
  std::optional<lcmtypes::NodeStatus> status;
  bus.subscribe_bytes("LOOKOUT_STATUS", [&status](std::span<const std::uint8_t> bytes) {
    status = lcmtypes::read_node_status(bytes);
  });
  const auto send = [&bus](std::int32_t sender, double time) {
    bus.publish(lcmtypes::Channels::kLocalEstimate,
                lcmtypes::to_wire(estimate(sender, 1, time, {2.0 * time, 0, 2, 0})));
  };
  send(1, 0.0);
  for (int k = 0; k < 300; ++k) send(2, 0.01 * k);
  send(1, 3.0);
  node.run({.idle_exit = 0.05});
  bus.drain();
  EXPECT_GE(node.fusion().count(Intake::accepted), 4);
  EXPECT_GT(node.shed(), 100);
  EXPECT_EQ(node.fusion().count(Intake::accepted) + node.refused() + node.shed(), 302);
  EXPECT_NE(node.fusion().global_of(1, 1), -1);  // It takes both of its estimates to have a vote.
  ASSERT_TRUE(status);
  EXPECT_NE(status->last_error.find("overloaded: shed "), std::string::npos) << status->last_error;
}

TEST_F(OnOneBus, TellsOfANodeWhoseTracksProveFalse) {
  std::string said;
  bus.subscribe_bytes("LOOKOUT_STATUS", [&said](std::span<const std::uint8_t> bytes) {
    if (const auto status = lcmtypes::read_node_status(bytes)) said = status->last_error;
  });
  for (int k = 0; k < 60; ++k) {  // A new track at each time, sent twice, where none was before.
    for (const double time : {0.5 * k, 0.5 * k + 0.25})
      bus.publish(lcmtypes::Channels::kLocalEstimate,
                  lcmtypes::to_wire(estimate(3, k, time, {100.0 * k, 0, 1, 0})));
  }
  run();
  EXPECT_NE(said.find("node 3 has credit "), std::string::npos) << said;
  EXPECT_NE(said.find(" %: its tracks prove false"), std::string::npos) << said;
}

}  // namespace
}  // namespace lookout::fusion
