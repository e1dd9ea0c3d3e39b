#include "fusion/local_track_store.hpp"

#include <gtest/gtest.h>

#include "tests/fusion/test_nodes.hpp"
#include "tests/fusion/two_nodes.hpp"

namespace lookout::fusion {
namespace {

using core::microseconds;
using testing::estimate;
using testing::target;
using testing::TwoNodes;

const Eigen::Vector4d kState(1, 2, 3, 4);

TEST(LocalTrackStore, TwoEstimatesMakeATrackletOneACandidate) {
  LocalTrackStore store({});
  store.add(estimate(1, 1, 0.0, kState));
  EXPECT_FALSE(store.votes(store.tracks().begin()->second, core::microseconds(0.0)));
  store.add(estimate(1, 1, 0.5, kState));
  EXPECT_TRUE(store.votes(store.tracks().begin()->second, core::microseconds(0.5)));
}

TEST(LocalTrackStore, OnASlowLinkACandidateMayVote) {
  LocalTrackStoreParams params;
  params.min_estimates = 1;
  LocalTrackStore store(params);
  store.add(estimate(1, 1, 0.0, kState));
  EXPECT_TRUE(store.votes(store.tracks().begin()->second, microseconds(0.0)));
}

TEST(LocalTrackStore, RefusesDuplicatesAndOlderEstimates) {
  LocalTrackStore store({});
  EXPECT_EQ(store.add(estimate(1, 1, 1.0, kState)), Intake::accepted);
  EXPECT_EQ(store.add(estimate(1, 1, 1.0, kState)), Intake::duplicate);
  EXPECT_EQ(store.add(estimate(1, 1, 0.5, kState)), Intake::out_of_order);
  EXPECT_EQ(store.add(estimate(1, 2, 0.5, kState)), Intake::accepted);  // Another track of the node.
  EXPECT_EQ(store.tracks().at({1, 1}).size(), 1u);
}

TEST(LocalTrackStore, ATrackletNeedsItsEstimatesCloseInTime) {
  LocalTrackStore store({});
  store.add(estimate(1, 1, 0.0, kState));
  store.add(estimate(1, 1, 5.5, kState));  // docs/fusion.md: at most 5 s apart, else a candidate again.
  EXPECT_FALSE(store.tracks().begin()->second.is_tracklet());
  store.add(estimate(1, 1, 6.0, kState));
  EXPECT_TRUE(store.tracks().begin()->second.is_tracklet());
}

TEST(LocalTrackStore, ASilentTrackLosesItsVoteAfterThreeOfItsNodesIntervals) {
  LocalTrackStore store({});
  for (int k = 0; k <= 4; ++k) store.add(estimate(1, 1, k, kState));  // One second apart.
  const LocalTrack& track = store.tracks().begin()->second;
  EXPECT_TRUE(store.votes(track, core::microseconds(6.9)));
  EXPECT_FALSE(store.votes(track, core::microseconds(7.1)));
}

TEST(LocalTrackStore, ATrackSkippedTwiceByItsNodeLosesItsVote) {
  LocalTrackStore store({});
  const auto votes = [&](double time) {
    return store.votes(store.tracks().at({1, 1}), core::microseconds(time));
  };
  for (int k = 0; k < 4; ++k) {  // Two tracks in turn, each once a second.
    store.add(estimate(1, 1, k, kState));
    store.add(estimate(1, 2, k + 0.5, kState));
  }
  store.add(estimate(1, 2, 4.5, kState));  // One of the other's turns: a message may have been lost.
  EXPECT_TRUE(votes(4.5));
  store.add(estimate(1, 2, 5.5, kState));  // Two; the node takes turns, so the first has ended.
  EXPECT_FALSE(votes(5.5));
  EXPECT_TRUE(store.votes(store.tracks().at({1, 2}), core::microseconds(5.5)));
}

TEST(LocalTrackStore, ALateNodeKeepsItsVoteByWhenItsMessagesArrive) {
  LocalTrackStore store({});
  for (int k = 0; k <= 8; ++k)  // Every half second, three seconds late.
    store.add(estimate(1, 1, 0.5 * k, kState), microseconds(0.5 * k + 3.0));
  const LocalTrack& track = store.tracks().begin()->second;
  EXPECT_TRUE(store.votes(track, microseconds(7.5)));
  EXPECT_FALSE(store.votes(track, microseconds(8.7)));  // Nothing for more than 1.6 s.
}

TEST(LocalTrackStore, ANodeThatReportsEverySixSecondsHasTracklets) {
  LocalTrackStore store({});
  for (int k = 0; k <= 3; ++k) store.add(estimate(1, 1, 6.0 * k, kState));
  const LocalTrack& track = store.tracks().begin()->second;
  EXPECT_TRUE(track.is_tracklet());
  EXPECT_TRUE(store.votes(track, microseconds(23.9)));
  EXPECT_FALSE(store.votes(track, microseconds(27.1)));  // 1.5 turns of 6 s.
}

TEST(LocalTrackStore, ATracksTurnIsAsLongAsItsNodeHasTracks) {
  LocalTrackStore store({});
  for (int k = 0; k <= 11; ++k) store.add(estimate(1, k % 3, 4.0 * k, kState));  // Each every 12 s.
  for (const auto& [key, track] : store.tracks()) EXPECT_TRUE(track.is_tracklet()) << key.second;
}

TEST(LocalTrackStore, ForgetsTheLongSilentAndBoundsItsMemory) {
  LocalTrackStoreParams params;
  params.max_tracks = 2;
  LocalTrackStore store(params);
  store.add(estimate(1, 1, 0.0, kState));
  store.add(estimate(2, 2, 20.0, kState));
  EXPECT_EQ(store.add(estimate(2, 3, 20.0, kState)), Intake::too_many);
  store.forget_silent(core::microseconds(31.0));
  EXPECT_EQ(store.tracks().size(), 1u);
}

TEST(LocalTrackStore, NoNodeTakesTheRoomOfTheOthers) {
  LocalTrackStore store({});
  for (int id = 0; id < 1000; ++id) {
    const auto outcome = store.add(estimate(1, id, 0.0, kState));
    EXPECT_EQ(outcome, id < 300 ? Intake::accepted : Intake::too_many);
  }
  EXPECT_EQ(store.add(estimate(2, 1, 0.0, kState)), Intake::accepted);
  store.forget_silent(core::microseconds(1000.0));
  EXPECT_TRUE(store.tracks().empty());
  EXPECT_EQ(store.add(estimate(1, 2000, 1000.0, kState)), Intake::accepted);
}

TEST(LocalTrackStore, ATrackKnowsHowLongItsNodeHasSentIt) {
  LocalTrack track(estimate(1, 1, 2.0, kState));
  EXPECT_EQ(track.life(), 0.0);
  for (int k = 3; k < 20; ++k) track.append(estimate(1, 1, k, kState));
  EXPECT_EQ(track.life(), 17.0);
  track.restart();
  EXPECT_EQ(track.life(), 0.0);
}

TEST(LocalTrackStore, KeepsTheNewestEightEstimates) {
  LocalTrack track(estimate(1, 1, 0.0, kState));
  for (int k = 1; k < 20; ++k) track.append(estimate(1, 1, k, kState));
  EXPECT_EQ(track.size(), 8u);
  EXPECT_EQ(track.newest().utime, core::microseconds(19.0));
  EXPECT_EQ(track.back(7).utime, core::microseconds(12.0));
}

TEST(LocalTrackStore, RefusesBadParameters) {
  LocalTrackStoreParams params;
  params.silent_rounds = 1.0;
  EXPECT_THROW(LocalTrackStore{params}, std::invalid_argument);
}

TEST_F(TwoNodes, DuplicatesAndStragglersChangeNothing) {
  Fusion clean{FusionParams{}};
  for (double time = 0.0; time <= 5.0; time += 0.5) {
    for (std::int32_t node : {1, 2}) {
      for (int id : {1, 2}) {
        LocalEstimate message = estimate(node, id, time, target(id, time));
        message.p_earth_node = {-50.0, node * 40.0};
        clean.add(message);
        send(node, id, time);
        send(node, id, time);                         // A duplicate ...
        if (time >= 1.0) send(node, id, time - 1.0);  // ... and an older one, out of order.
      }
    }
    update(time);
    const auto expected = clean.update(microseconds(time));
    ASSERT_EQ(expected.size(), tracks.size());
    for (std::size_t i = 0; i < tracks.size(); ++i) EXPECT_EQ(tracks[i].state, expected[i].state);
  }
  EXPECT_EQ(fusion.count(Intake::duplicate), 11 * 4);
  EXPECT_EQ(fusion.count(Intake::out_of_order), 9 * 4);
}

}  // namespace
}  // namespace lookout::fusion
