#include "tracking/csht_tracker.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/support/patch_sea.hpp"
#include "tests/support/sonar_scene.hpp"
#include "tracking/tracking_chain.hpp"

namespace lookout::tracking {
namespace {

class CshtTrackerTest : public testing::Test {
 protected:
  std::span<const core::Track> step(const std::vector<core::MotionElement>& script,
                                    const std::vector<Eigen::Vector2d>& detections = {}) {
    const core::PosedScan scan = scan_of(scan_++, detections);
    const auto offered = tracker_.take(scan).tracks;
    offered_.assign(offered.begin(), offered.end());
    return tracker_.update(scan, script);
  }
  static core::MotionElement element(double north, double north_velocity, double existence = 1.0) {
    core::MotionElement element;
    element.position = {north, 0.0};
    element.velocity = {north_velocity, 0.0};
    element.covariance = Eigen::Matrix4d::Identity();
    element.existence = existence;
    return element;
  }

  std::vector<core::Track> offered_;
  CshtTracker tracker_{{}, {}};
  int scan_ = 0;
};

// The estimator counts by the tracker's map, too.
TEST(CshtTracker, LearnsWhereFalseReturnsAreDense) {
  const auto confirmed = [](bool enabled) {
    ChainParams params;
    params.tracker.name = "csht";
    params.tracker.own["csht"]["clutter.map.enabled"] = enabled ? 1.0 : 0.0;
    const auto pipeline = make_pipeline(params, {});
    return confirmed_in_patch([&](const core::PosedScan& scan) { return pipeline->step(scan).tracks; });
  };
  EXPECT_GT(confirmed(false), 2.0);
  EXPECT_LT(confirmed(true), 1.0);
}

TEST_F(CshtTrackerTest, ReportsANewElementAtOnce) {
  const auto tracks = step({element(50.0, 1.0)});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].status, core::TrackStatus::confirmed);
  EXPECT_EQ(tracks[0].state, Eigen::Vector4d(50.0, 0.0, 1.0, 0.0));
}

TEST_F(CshtTrackerTest, KeepsTheIdentityOfAnExistingTarget) {
  step({element(50.0, 1.0)});
  const auto tracks = step({element(50.7, 1.1)});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_EQ(tracks[0].state(0), 50.7);  // young: the window estimate as it is
}

TEST_F(CshtTrackerTest, AnElementFarFromEveryTrackIsANewTarget) {
  step({element(50.0, 1.0)});
  EXPECT_EQ(step({element(50.5, 1.0), element(80.0, 0.0)}).size(), 2U);
}

// An offered track may drag weak evidence away from itself; that must not become its twin.
TEST_F(CshtTrackerTest, AnElementThatOnlyAnOfferCarriedIsNoNewTarget) {
  step({element(50.0, 1.0)});
  core::MotionElement drawn_away = element(80.0, 0.0);
  drawn_away.of_known_track = true;
  EXPECT_EQ(step({element(50.5, 1.0), drawn_away}).size(), 1U);
}

TEST_F(CshtTrackerTest, AnElementThatHardlyExistsIsAFalseTarget) {
  EXPECT_TRUE(step({element(50.0, 1.0, 0.4)}).empty());
}

TEST_F(CshtTrackerTest, OffersItsTracksAsTheyWereAtTheLastScan) {
  step({element(50.0, 1.0)});
  step({});
  ASSERT_EQ(offered_.size(), 1U);
  EXPECT_NEAR(offered_[0].state(0), 50.0, 1e-12);
}

TEST_F(CshtTrackerTest, DropsATrackThatTheWindowNoLongerSupports) {
  step({element(50.0, 1.0)});
  EXPECT_EQ(step({}).size(), 1U);  // 1 + .2 x 1 misses are allowed
  EXPECT_TRUE(step({}).empty());
}

TEST_F(CshtTrackerTest, AnOldTrackFollowsItsSamples) {
  for (int k = 0; k < 10; ++k) step({element(50.0, 0.0)});
  const auto tracks = step({element(50.0, 0.0)}, {{51.0, 0.0}});
  EXPECT_GT(tracks[0].state(0), 50.0);  // pulled towards the detection
  EXPECT_LT(tracks[0].state(0), 51.0);
}

TEST_F(CshtTrackerTest, TellsWhatBeganTurnedAndEndedATrack) {
  ASSERT_TRUE(tracker_.explains());
  std::string told;
  tracker_.explain_to(
      [&told](const TrackDecision& decision) { told += std::string(to_string(decision.kind)) + " "; });
  step({element(50.0, 0.0)});
  for (int k = 1; k < 40; ++k) step({element(50.0, 0.0)}, {{50.0, 0.0}});
  EXPECT_EQ(told, "begin confirm ");
  for (int k = 0; k < 40; ++k)  // It starts at 1 m/s.
    step({element(50.0 + 0.5 * k, 1.0)}, {{50.0 + 0.5 * k, 0.0}});
  EXPECT_EQ(told.rfind("begin confirm manoeuvre ", 0), 0U) << told;
  for (int k = 0; k < 10; ++k) step({});
  EXPECT_TRUE(told.ends_with("end ")) << told;
}

TEST(CshtTracker, RefusesParametersOutOfRange) {
  CshtTrackerParams params;
  params.min_existence = 1.5;
  EXPECT_THROW(CshtTracker(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
