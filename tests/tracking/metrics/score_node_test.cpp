#include "tracking/metrics/score_node.hpp"

#include <gtest/gtest.h>

#include "lcmtypes/convert_reports.hpp"

namespace lookout::tracking {
namespace {

class ScoreNodeTest : public ::testing::Test {
 protected:
  /// One true target at the origin.
  void truth(std::int64_t utime) {
    core::GroundTruth truth;
    truth.utime = utime;
    truth.targets.push_back({1, {0.0, 0.0}, {0.0, 0.0}, true});
    bus_.publish("GROUND_TRUTH", lcmtypes::to_wire(truth));
  }
  /// One confirmed track `error` metres off.
  void track(std::int64_t utime, double error) {
    std::vector<core::Track> tracks(1);
    tracks[0].status = core::TrackStatus::confirmed;
    tracks[0].state[0] = error;
    bus_.publish("TRACKS", lcmtypes::to_wire({utime, 0, 0}, tracks).message);
  }

  lcmtypes::Bus bus_{"memq://"};
  ScoreNode node_{bus_, {}, Scorer()};
};

TEST_F(ScoreNodeTest, ScoresWhatIsOfOneTimeWhicheverComesFirst) {
  truth(1000);
  track(1000, 3.0);
  track(2001, 5.0);
  truth(2000);  // Within a microsecond.
  node_.run({.idle_exit = 0.05});
  EXPECT_EQ(node_.scorer().num_scans(), 2);
  EXPECT_DOUBLE_EQ(node_.scorer().mean().position.total, 4.0);  // The mean of 3 and 5.
}

TEST_F(ScoreNodeTest, LeavesOutWhatHasNoOtherHalf) {
  truth(1000);
  track(5000, 3.0);
  node_.run({.idle_exit = 0.05});
  EXPECT_EQ(node_.scorer().num_scans(), 0);
  EXPECT_EQ(node_.truths(), 1);
  EXPECT_EQ(node_.tracks(), 1);
}

// A thousand may wait for their other half; what goes for those behind them is told.
TEST_F(ScoreNodeTest, TellsWhatItGivesUp) {
  std::string told;
  bus_.subscribe_read("LOOKOUT_STATUS", &lcmtypes::read_node_status,
                      [&](const lcmtypes::NodeStatus& status) { told = status.last_error; });
  for (int i = 0; i < 1005; ++i) {
    truth(1000L * i);
    bus_.drain();
  }
  node_.run({.idle_exit = 0.05});
  bus_.drain();
  EXPECT_EQ(told, "5 truths and track lists given up: nothing came at their times");
}

TEST_F(ScoreNodeTest, PublishesTheScoreOfEachScan) {
  std::optional<ospa_t> heard;
  bus_.subscribe_bytes("OSPA",
                       [&](auto bytes) { heard = lcmtypes::decode<ospa_t>(bytes.data(), bytes.size()); });
  truth(1000);
  track(1000, 30.0);
  node_.run({.idle_exit = 0.05});
  bus_.drain();
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->utime, 1000);
  EXPECT_EQ(heard->total, 20.0);  // Farther off than the cut-off.
  EXPECT_EQ(heard->cutoff, 20.0);
  EXPECT_EQ(heard->order, 2.0);
  EXPECT_EQ(heard->num_truth, 1);
  EXPECT_EQ(heard->num_tracks, 1);
}

}  // namespace
}  // namespace lookout::tracking
