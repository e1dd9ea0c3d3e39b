#include "fusion/global_tracks.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "tests/fusion/test_nodes.hpp"
#include "tests/fusion/two_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::estimate;
using testing::target;
using testing::TwoNodes;

constexpr int kNone = -1;

/// Tracks told which local track supports which, fused to the newest estimate of the first supporter.
class GlobalTracksTest : public ::testing::Test {
 protected:
  struct Vote {
    std::int32_t node;
    Eigen::Vector2d position;
    int place;  ///< In the picture, or kNone.
  };

  /// One update at `time` [s].
  void update(double time, const std::vector<Vote>& votes) {
    globals.predict(core::microseconds(time));
    for (const Vote& vote : votes) {
      locals.push_back(testing::tracklet(vote.node, {vote.position.x(), vote.position.y(), 1, 0}));
      const Contribution contribution{&locals.back(), locals.back().newest().state};
      globals.add_support({&contribution, 1}, {&vote.place, 1});
    }
    std::vector<FusedState> fused;
    for (const TrackGroup& group : globals.groups())
      fused.push_back({group.contributions.front().current, Eigen::Matrix4d::Identity()});
    globals.take(fused, TrackAssociation{AssociationParams{}});
  }

  std::deque<LocalTrack> locals;  ///< Contributions point to them.
  GlobalTracks globals{GlobalTracksParams{}};
};

TEST_F(GlobalTracksTest, CarriesTracksAndStartsOneForAnUnassociatedTracklet) {
  update(1.0, {{1, {0, 0}, kNone}});
  ASSERT_EQ(globals.tracks().size(), 1u);
  globals.predict(core::microseconds(3.0));
  EXPECT_EQ(globals.predicted_for(1)[0], Eigen::Vector4d(2, 0, 1, 0));  // Two seconds at 1 m/s, Eq. (16).
}

TEST_F(GlobalTracksTest, ANewcomerHasNoVoteWhereAnotherNodeSpeaks) {
  update(1.0, {{1, {0, 0}, kNone}});
  update(2.0, {{1, {1, 0}, 0}, {2, {3, 0}, 0}});
  EXPECT_NEAR(globals.tracks()[0].existence, 0.9, 1e-12);  // 1 - 0.1^1: one voice.
  EXPECT_EQ(globals.supported_by({2, 1}), 0);              // Yet it is known where it belongs.
  EXPECT_EQ(globals.past_of(locals.back()).place, -1);
}

TEST_F(GlobalTracksTest, ANewcomerSpeaksAtOnceForATrackThatCoasts) {
  update(1.0, {{1, {0, 0}, kNone}});
  update(2.0, {{1, {1, 0}, 0}});
  update(2.5, {});
  EXPECT_EQ(globals.tracks()[0].status, core::TrackStatus::coasting);
  update(3.0, {{2, {2, 0}, 0}});
  EXPECT_EQ(globals.tracks()[0].status, core::TrackStatus::confirmed);
}

TEST_F(GlobalTracksTest, KnowsWhoIsAloneWithATrack) {
  update(1.0, {{1, {0, 0}, kNone}, {2, {0, 0}, 0}});  // Both at its birth: both have a vote.
  EXPECT_NEAR(globals.tracks()[0].existence, 0.99, 1e-12);
  globals.predict(core::microseconds(2.0));
  EXPECT_FALSE(globals.past_of(locals.front()).alone);
  update(2.5, {{1, {1.5, 0}, 0}});
  globals.predict(core::microseconds(3.0));
  EXPECT_TRUE(globals.past_of(locals.back()).alone);
}

TEST_F(GlobalTracksTest, TwoTracksOfTwoNodesBecomeOneAfterThreeUpdatesAndTheOlderNumberStays) {
  update(1.0, {{1, {0, 0}, kNone}});
  for (double time : {2.0, 3.0}) {
    update(time, {{1, {time - 1, 0}, 0}, {2, {time - 1, 0.5}, time == 2.0 ? kNone : 1}});
    EXPECT_EQ(globals.tracks().size(), 2u);
  }
  update(4.0, {{1, {3, 0}, 0}, {2, {3, 0.5}, 1}});
  ASSERT_EQ(globals.tracks().size(), 1u);
  EXPECT_EQ(globals.tracks()[0].id, 1);
  ASSERT_EQ(globals.merged().size(), 1u);
  EXPECT_EQ(globals.merged()[0], (std::pair<std::int64_t, std::int64_t>{2, 1}));
  EXPECT_EQ(globals.supported_by({2, 1}), 0);
}

TEST_F(GlobalTracksTest, OfTwoTracksThatBecomeOneTheNumberThatMoreNodesGoByStays) {
  update(1.0, {{1, {0, 0}, kNone}, {2, {0, 0.5}, kNone}, {3, {0, 0.5}, 1}});
  for (double time : {2.0, 3.0})
    update(time, {{1, {time - 1, 0}, 0}, {2, {time - 1, 0.5}, 1}, {3, {time - 1, 0.5}, 1}});
  ASSERT_EQ(globals.tracks().size(), 1u);
  EXPECT_EQ(globals.tracks()[0].id, 2);
  EXPECT_EQ(globals.merged()[0], (std::pair<std::int64_t, std::int64_t>{1, 2}));
  EXPECT_EQ(globals.supported_by({1, 1}), 0);
}

TEST_F(GlobalTracksTest, AGuestIsHeldAgainstTheOthersAlone) {
  update(1.0, {{1, {0, 0}, kNone}, {2, {4, 0}, 0}, {3, {8, 0}, 0}});    // 2 and 3 vote, not trusted yet.
  globals.predict(core::microseconds(2.0));                             // All move on by a metre.
  EXPECT_EQ(globals.predicted_for(1)[0], Eigen::Vector4d(1, 0, 1, 0));  // Fused: the first supporter's.
  EXPECT_EQ(globals.predicted_for(2)[0], Eigen::Vector4d(5, 0, 1, 0));  // Mean of nodes 1 and 3.
  EXPECT_EQ(globals.predicted_for(3)[0], Eigen::Vector4d(3, 0, 1, 0));  // Mean of nodes 1 and 2.
  EXPECT_EQ(globals.past_of(locals.back()).place, -1);
}

TEST_F(GlobalTracksTest, ACoastingTrackEndsAfterAsLongAsItLivedAndItsNumberIsNotUsedAgain) {
  update(1.0, {{1, {0, 0}, kNone}});
  update(3.0, {{1, {2, 0}, 0}});
  update(5.0, {});  // Two seconds of life, two of silence.
  EXPECT_EQ(globals.tracks().size(), 1u);
  update(5.1, {});
  EXPECT_TRUE(globals.tracks().empty());
  update(6.0, {{1, {5, 0}, kNone}});
  EXPECT_EQ(globals.tracks()[0].id, 2);
}

TEST_F(GlobalTracksTest, CoastingGrowsTheCovariance) {
  update(1.0, {{1, {0, 0}, kNone}});
  update(3.0, {{1, {2, 0}, 0}});
  const Eigen::Matrix4d before = globals.tracks()[0].covariance;
  update(4.5, {});
  // 1 + dt^2 1 + q dt^3 / 3 after dt = 1.5 s from the unit matrix, q = 0.01.
  EXPECT_NEAR(globals.tracks()[0].covariance(0, 0), before(0, 0) + 2.25 + 0.01 * 3.375 / 3.0, 1e-12);
  EXPECT_NEAR(globals.tracks()[0].covariance(2, 2), before(2, 2) + 0.015, 1e-12);
}

TEST(GlobalTracks, RefusesBadParameters) {
  GlobalTracksParams params;
  params.probation = 0;
  EXPECT_THROW(GlobalTracks{params}, std::invalid_argument);
}

TEST_F(TwoNodes, AllFallSilentCoastEndAndKeepTheirNumbersApart) {
  run(0.0, 20.0);
  update(24.0);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].status, core::TrackStatus::coasting);
  EXPECT_NEAR(error(0, 1, 24.0), 0.0, 1e-6);
  update(31.0);
  EXPECT_TRUE(tracks.empty());
  run(32.0, 36.0);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 3);  // A number is never used again.
}

TEST_F(TwoNodes, TwoTracksOfOneTargetBecomeOneAndTheOlderNumberStays) {
  for (double time = 0.0; time <= 4.0; time += 0.5) {  // Node 2 begins 40 m off and comes near.
    send(1, 1, time);
    LocalEstimate apart = estimate(2, 1, time, target(1, time));
    apart.state(1) += 40.0 - 10.0 * time;
    fusion.add(apart);
    update(time);
  }
  run(4.5, 8.0);
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 1);
}

}  // namespace
}  // namespace lookout::fusion
