#include "tracking/node/tracker_node.hpp"

#include <gtest/gtest.h>

#include <lookout/node_status_t.hpp>

#include "core/input_error.hpp"
#include "lcmtypes/state_file.hpp"
#include "tests/support/temporary_directory.hpp"

namespace lookout::tracking {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

constexpr int kTentative = 2;  ///< Scans for which the stub's second track is tentative.

/// One confirmed and, in the first scans, one tentative track, and the sensor's figures.
class StubTracker final : public Tracker {
 public:
  StubTracker() {
    tracks_[0].id = 11;
    tracks_[0].status = core::TrackStatus::confirmed;
  }
  std::span<const core::Track> update(const core::PosedScan&, std::span<const core::MotionElement>) override {
    if (++updates_ > kTentative) tracks_[1].status = core::TrackStatus::confirmed;
    return tracks_;
  }
  std::optional<core::SensorEstimate> sensor_estimate() const override {
    core::SensorEstimate estimate;
    estimate.range_sigma = 3.0;
    return estimate;
  }
  std::int64_t next_id() const override { return 12; }
  void set_next_id(std::int64_t /*id*/) override {}

 private:
  std::vector<core::Track> tracks_{2};
  int updates_ = 0;
};

/// One motion element at every scan.
class StubEstimator final : public csht::MotionEstimator {
 public:
  std::span<const core::MotionElement> update(const core::PosedScan&) override { return elements_; }
  core::EstimatorMethod method() const override { return core::EstimatorMethod::ransac; }
  int window_scans() const override { return 13; }

 private:
  std::vector<core::MotionElement> elements_{1};
};

std::unique_ptr<TrackingChain> stub_chain(TrackingChain::OnResult on_result, TrackingChain::Report report) {
  return std::make_unique<TrackingChain>(
      ChainParams(),
      [](const core::SonarParams&) {
        return std::make_unique<ScanPipeline>(std::make_unique<StubEstimator>(),
                                              std::make_unique<StubTracker>());
      },
      std::move(on_result), std::move(report));
}

class TrackerNodeTest : public ::testing::Test {
 protected:
  static TrackerNodeParams params() {
    TrackerNodeParams params;
    params.channel_prefix = "AUV1_";
    params.node_id = 3;
    params.publish_estimates = true;
    return params;
  }
  TrackerNodeTest() {
    bus_.subscribe<track_list_t>("AUV1_TRACKS",
                                 [this](const lcmtypes::KeyedTracks& tracks) { tracks_.push_back(tracks); });
    bus_.subscribe<motion_elements_t>(
        "AUV1_MOTION_ELEMENTS",
        [this](const lcmtypes::KeyedElements& elements) { elements_.push_back(elements); });
    bus_.subscribe<sensor_estimate_t>("AUV1_SENSOR_ESTIMATE", [this](const auto&) { ++sensor_estimates_; });
    bus_.subscribe<local_estimate_t>(
        "LOCAL_ESTIMATE", [this](const core::LocalEstimate& estimate) { estimates_.push_back(estimate); });
    bus_.subscribe_bytes("AUV1_LOOKOUT_STATUS", [this](auto bytes) {
      status_ = lcmtypes::decode<node_status_t>(bytes.data(), bytes.size());
    });
  }
  void state(std::int64_t utime) {
    bus_.publish("AUV1_VEHICLE_STATE",
                 lcmtypes::to_wire(core::VehicleState{utime, {5.0, 6.0, 0.0}, {0.0, 0.0}}));
  }
  void scan(std::int64_t utime, std::int64_t sequence) {
    core::SonarScan scan;
    scan.utime = utime;
    scan.sequence = sequence;
    scan.sensor_id = 9;
    scan.bearing_step = 0.1;
    scan.max_range = 100.0;
    scan.num_beams = 3;
    bus_.publish("AUV1_SONAR_SCAN", lcmtypes::to_wire(scan));
  }
  /// Lets the node take everything that was published, and the test everything that the node did.
  void run() {
    node_.run({.idle_exit = 0.05});
    bus_.drain();
  }

  lcmtypes::Bus bus_{"memq://"};
  std::vector<lcmtypes::KeyedTracks> tracks_;
  std::vector<lcmtypes::KeyedElements> elements_;
  std::vector<core::LocalEstimate> estimates_;
  int sensor_estimates_ = 0;
  std::optional<node_status_t> status_;
  TrackerNode node_{bus_, params(), &stub_chain, [](const std::string&) {}};
};

TEST_F(TrackerNodeTest, PublishesEachResultOnceForEachAcceptedScan) {
  for (int i = 0; i < 5; ++i) {
    state(i * kSecond);
    scan(i * kSecond, i);
  }
  run();
  ASSERT_EQ(tracks_.size(), 5u);
  ASSERT_EQ(elements_.size(), 5u);
  EXPECT_EQ(sensor_estimates_, 5);
  EXPECT_EQ(tracks_[3].key.utime, 3 * kSecond);
  EXPECT_EQ(tracks_[3].key.sequence, 3);
  EXPECT_EQ(tracks_[3].key.source_id, 9);
  EXPECT_EQ(tracks_[3].tracks.size(), 2u);
  EXPECT_EQ(elements_[3].key.sequence, 3);
  EXPECT_EQ(elements_[3].method, core::EstimatorMethod::ransac);
  EXPECT_EQ(elements_[3].window_scans, 13);
}

TEST_F(TrackerNodeTest, PublishesConfirmedTracksAsLocalEstimates) {
  state(0);
  scan(0, 0);
  run();
  ASSERT_EQ(estimates_.size(), 1u);
  EXPECT_EQ(estimates_[0].track_id, 11);
  EXPECT_EQ(estimates_[0].node_id, 3);
  EXPECT_EQ(estimates_[0].p_earth_node, Eigen::Vector2d(5.0, 6.0));
  EXPECT_FALSE(estimates_[0].covariance);  // Too long for the thin link unless it is asked for.
}

TEST_F(TrackerNodeTest, SurvivesHostileInputAndTellsInItsStatus) {
  state(0);
  scan(0, 0);
  bus_.publish("AUV1_SONAR_SCAN", lcmtypes::to_wire(core::VehicleState{}));  // Another type.
  core::SonarScan damaged;
  damaged.utime = kSecond;
  damaged.num_beams = -1;
  bus_.publish("AUV1_SONAR_SCAN", lcmtypes::to_wire(damaged));
  scan(0, 0);        // A repeat.
  scan(kSecond, 4);  // After a loss of three, and without a pose.
  run();
  ASSERT_TRUE(status_);
  EXPECT_EQ(status_->node_id, 3);
  EXPECT_EQ(status_->node, "lookout track");
  EXPECT_EQ(status_->accepted, 1);
  EXPECT_EQ(status_->rejected, 4);
  EXPECT_EQ(status_->dropped, 3);
  EXPECT_FALSE(status_->last_error.empty());
  EXPECT_EQ(tracks_.size(), 1u);
}

TEST_F(TrackerNodeTest, SaysInItsStatusHowItIs) {
  run();
  ASSERT_TRUE(status_);
  EXPECT_EQ(status_->last_error.rfind("no data: no scan heard yet", 0), 0u) << status_->last_error;
}

TEST_F(TrackerNodeTest, TellsOfAnotherTrackerUnderItsName) {
  lcmtypes::StatusBoard(bus_, "AUV1_LOOKOUT_STATUS", "lookout track", 4).publish({}, "");  // Another node.
  run();
  EXPECT_EQ(status_->last_error.find("another tracker"), std::string::npos);
  lcmtypes::StatusBoard(bus_, "AUV1_LOOKOUT_STATUS", "lookout track", 3).publish({}, "twin");
  run();
  EXPECT_NE(status_->last_error.find("another tracker publishes on AUV1_LOOKOUT_STATUS as node 3"),
            std::string::npos)
      << status_->last_error;
}

/// The same with room for three scans, and a file for its state.
class SmallTrackerNodeTest : public ::testing::Test {
 protected:
  std::unique_ptr<TrackerNode> node() {
    TrackerNodeParams params;
    params.max_waiting = 3;
    params.state_file = directory_.file("state");
    return std::make_unique<TrackerNode>(bus_, params, &stub_chain,
                                         [this](const std::string& line) { said_.push_back(line); });
  }
  void scans(int from, int to) {
    for (int k = from; k < to; ++k) {
      core::SonarScan scan;
      scan.utime = k * kSecond;
      scan.sequence = k;
      scan.bearing_step = 0.1;
      scan.max_range = 100.0;
      scan.num_beams = 3;
      bus_.publish("VEHICLE_STATE", lcmtypes::to_wire(core::VehicleState{scan.utime, {}, {0.0, 0.0}}));
      bus_.publish("SONAR_SCAN", lcmtypes::to_wire(scan));
    }
  }
  tests::TemporaryDirectory directory_;
  lcmtypes::Bus bus_{"memq://"};
  std::vector<std::string> said_;
};

TEST_F(SmallTrackerNodeTest, ShedsTheOldestWhenTooManyWaitAndCountsThem) {
  const auto tracker = node();
  scans(0, 10);
  tracker->run({.idle_exit = 0.05});
  EXPECT_EQ(tracker->figures().shed, 7);
  EXPECT_EQ(tracker->figures().accepted, 3);
  EXPECT_EQ(tracker->figures().dropped, 0);  // What is shed is not lost.
  EXPECT_EQ(tracker->counts().received, 10);
  EXPECT_EQ(tracker->health().state(), NodeState::overloaded);
  ASSERT_FALSE(said_.empty());
  EXPECT_NE(said_[0].find("overloaded"), std::string::npos);
  scans(10, 13);
  tracker->run({.idle_exit = 0.05});
  EXPECT_EQ(tracker->figures().accepted, 6);
  EXPECT_EQ(tracker->figures().shed, 7);
}

TEST_F(SmallTrackerNodeTest, KeepsItsStateAndGoesOnByIt) {
  {
    const auto tracker = node();
    scans(0, 3);
    tracker->run({.idle_exit = 0.05});
  }
  lcmtypes::Bus again("memq://");
  TrackerNodeParams params;
  params.state_file = directory_.file("state");
  const TrackerNode next(again, params, &stub_chain,
                         [this](const std::string& line) { said_.push_back(line); });
  ASSERT_FALSE(said_.empty());
  EXPECT_NE(said_.back().find("3 scans tracked again"), std::string::npos) << said_.back();
}

TEST_F(SmallTrackerNodeTest, AStopWhileItsStateIsTrackedAgainEndsThatAndLeavesTheState) {
  {
    const auto tracker = node();
    scans(0, 3);
    tracker->run({.idle_exit = 0.05});
  }
  said_.clear();
  TrackerNodeParams params;
  params.state_file = directory_.file("state");
  params.stopped = [] { return true; };
  lcmtypes::Bus again("memq://");
  TrackerNode tracker(again, params, &stub_chain, [this](const std::string& line) { said_.push_back(line); });
  tracker.run({.stopped = params.stopped});
  EXPECT_EQ(tracker.counts().accepted, 0);
  EXPECT_EQ(lcmtypes::load_state(directory_.file("state")).memory->scans.size(), 3u);
  for (const std::string& line : said_) EXPECT_EQ(line.find("tracked again"), std::string::npos) << line;
}

// Whoever hears of a track and then ends the process finds it in the state, though the state is two seconds
// old otherwise.
TEST_F(SmallTrackerNodeTest, KeepsAnIdentityBeforeItIsTold) {
  std::vector<std::int64_t> kept;
  bus_.subscribe<track_list_t>("TRACKS", [&](const lcmtypes::KeyedTracks&) {
    const auto state = lcmtypes::load_state(directory_.file("state"));
    if (state.memory && !state.memory->tracks.empty()) kept.push_back(state.memory->tracks[0].id);
  });
  const auto tracker = node();
  scans(0, 1);
  tracker->run({.idle_exit = 0.05});
  EXPECT_EQ(kept, std::vector<std::int64_t>{11});
}

TEST_F(SmallTrackerNodeTest, KeepsAnIdentityBeforeItIsToldAsConfirmed) {
  std::vector<core::TrackStatus> kept;
  bus_.subscribe<track_list_t>("TRACKS", [&](const lcmtypes::KeyedTracks&) {
    kept.push_back(lcmtypes::load_state(directory_.file("state")).memory->tracks.at(1).status);
  });
  const auto tracker = node();
  scans(0, kTentative + 1);
  tracker->run({.idle_exit = 0.05});
  using enum core::TrackStatus;
  EXPECT_EQ(kept, (std::vector{tentative, tentative, confirmed}));
}

TEST_F(SmallTrackerNodeTest, ADamagedStateIsAWordAndACleanStart) {
  directory_.write("state", "nonsense");
  node();
  ASSERT_FALSE(said_.empty());
  EXPECT_NE(said_[0].find("is no state of this version; starting without"), std::string::npos) << said_[0];
}

TEST(TrackerNode, RefusesTheNodeIdOfProgramsThatTrackNothing) {
  lcmtypes::Bus bus("memq://");
  TrackerNodeParams params;
  params.node_id = 0;
  EXPECT_THROW(TrackerNode(bus, params, &stub_chain, [](const std::string&) {}), core::InputError);
}

}  // namespace
}  // namespace lookout::tracking
