#include "fusion/pairings.hpp"

#include <gtest/gtest.h>

#include "tests/fusion/test_nodes.hpp"
#include "tests/fusion/two_nodes.hpp"

namespace lookout::fusion {
namespace {

using testing::estimate;
using testing::TwoNodes;

constexpr std::int64_t kTrack = 7, kOther = 8;

/// A local track that has sent `messages`, half a second apart.
LocalTrack heard(int messages) {
  LocalTrack track(testing::estimate(2, 1, 0.0, {0, 0, 1, 0}));
  for (int k = 1; k < messages; ++k) track.append(testing::estimate(2, 1, 0.5 * k, {0, 0, 1, 0}));
  return track;
}

TEST(Pairings, ATrackWithoutAnotherVoiceIsVotedForAtOnce) {
  Pairings pairings(3);
  EXPECT_TRUE(pairings.pair(heard(2), kTrack, Company::none));
  EXPECT_EQ(pairings.trusted_in(heard(2)), kTrack);
}

TEST(Pairings, ANewcomerVotesWithItsThirdMessageForTheSameTrack) {
  Pairings pairings(3);
  EXPECT_FALSE(pairings.pair(heard(2), kTrack, Company::voices));
  EXPECT_FALSE(pairings.pair(heard(2), kTrack, Company::voices));  // The same message again proves nothing.
  EXPECT_EQ(pairings.global_of(heard(2).key()), kTrack);
  EXPECT_EQ(pairings.trusted_in(heard(2)), -1);
  EXPECT_FALSE(pairings.pair(heard(3), kTrack, Company::voices));
  EXPECT_TRUE(pairings.pair(heard(4), kTrack, Company::voices));
  EXPECT_EQ(pairings.trusted_in(heard(4)), kTrack);
}

TEST(Pairings, NodesThatBringATrackUpTogetherVoteAtOnceAndAreTrustedFromTheThirdMessage) {
  Pairings pairings(3);
  EXPECT_TRUE(pairings.pair(heard(2), kTrack, Company::newcomers));
  EXPECT_EQ(pairings.trusted_in(heard(2)), -1);
  EXPECT_TRUE(pairings.pair(heard(3), kTrack, Company::voices));
  EXPECT_EQ(pairings.trusted_in(heard(3)), -1);
  EXPECT_TRUE(pairings.pair(heard(4), kTrack, Company::voices));
  EXPECT_EQ(pairings.trusted_in(heard(4)), kTrack);
}

TEST(Pairings, AChangeOfMindBeginsTheProbationAnew) {
  Pairings pairings(3);
  for (int messages : {2, 3}) EXPECT_FALSE(pairings.pair(heard(messages), kTrack, Company::voices));
  for (int messages : {4, 5}) EXPECT_FALSE(pairings.pair(heard(messages), kOther, Company::voices));
  EXPECT_TRUE(pairings.pair(heard(6), kOther, Company::voices));
}

TEST(Pairings, AVoteOnceGivenStaysWhenOthersCome) {
  Pairings pairings(3);
  pairings.pair(heard(2), kTrack, Company::none);
  EXPECT_TRUE(pairings.pair(heard(3), kTrack, Company::voices));
}

TEST(Pairings, ATrackThatBeganAgainHasNoPast) {
  Pairings pairings(3);
  pairings.pair(heard(9), kTrack, Company::none);
  EXPECT_EQ(pairings.trusted_in(heard(2)), -1);
  EXPECT_FALSE(pairings.pair(heard(2), kTrack, Company::voices));
}

TEST(Pairings, FollowsAMergerAndForgets) {
  Pairings pairings(3);
  pairings.pair(heard(2), kOther, Company::none);
  pairings.rename(kOther, kTrack);
  EXPECT_EQ(pairings.trusted_in(heard(2)), kTrack);
  pairings.forget_unknown({});
  EXPECT_EQ(pairings.global_of(heard(2).key()), -1);
}

TEST_F(TwoNodes, ARestartedNodeMayUseTheNumbersOfOthers) {
  run(0.0, 5.0);
  for (double time = 5.5; time <= 20.0; time += 0.5) {
    for (int id : {1, 2}) {
      send(1, id, time);
      if (time >= 12.0) send(2, id, time, time, 3 - id);  // Each target under the other's old number.
    }
    update(time);
  }
  ASSERT_EQ(tracks.size(), 2u);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_NEAR(error(0, 1, 20.0), 0.0, 1e-6);
  EXPECT_NEAR(error(1, 2, 20.0), 0.0, 1e-6);
}

TEST_F(TwoNodes, ARestartedNodesFirstGuessesWhereTargetsMeetCostNoNumber) {
  // Two targets pass 3 m apart. A tracker that has just started guesses: its first two estimates of each
  // stand nearer to the other one and have its velocity. Node 1 must keep both numbers and both places
  // meanwhile.
  const auto meeting = [](int id, double time) {
    return id == 1 ? Eigen::Vector4d(0, 0, 0.5, 0.2) : Eigen::Vector4d(0.2 * (time - 12.0), 3.0, 0.7, -0.1);
  };
  const auto guess = [&](int id, double time) -> Eigen::Vector4d {
    if (time >= 13.0) return meeting(id, time);
    const Eigen::Vector4d own = meeting(id, time), other = meeting(3 - id, time);
    return (Eigen::Vector4d() << 0.4 * own.head<2>() + 0.6 * other.head<2>(), other.tail<2>()).finished();
  };
  const auto sent = [&](std::int32_t node, std::int64_t track_id, double time, const Eigen::Vector4d& state) {
    LocalEstimate message = estimate(node, track_id, time, state);
    message.p_earth_node = {-50.0, node * 40.0};
    fusion.add(message);
  };
  for (double time = 0.0; time <= 20.0; time += 0.5) {
    for (int id : {1, 2}) {
      sent(1, id, time, meeting(id, time));
      if (time >= 12.0) sent(2, 50 + id, time, guess(id, time));
    }
    update(time);
    if (time < 1.0) continue;
    ASSERT_EQ(fusion.global_of(1, 1), 1) << time;
    ASSERT_EQ(fusion.global_of(1, 2), 2) << time;
    EXPECT_LT((tracks[0].state - meeting(1, time)).norm(), 0.1) << time;
  }
  EXPECT_EQ(fusion.global_of(2, 51), 1);
  EXPECT_NEAR(tracks[0].existence, 0.99, 1e-9);  // Both nodes speak again.
}

TEST(Pairings, AWrongGuessWhereAllBeginTogetherIsMended) {
  // Two targets side by side, 4 m apart. Both nodes begin at once; the second sees each nearer to the other
  // one at first and settles within two seconds. Its votes draw both tracks between the targets, where each
  // pairing is as good as the other: held against the fused tracks the wrong one would stay for good.
  FusionParams params;
  params.method = "mean";
  Fusion fusion(params);
  std::span<const core::Track> tracks;
  const auto abreast = [](double row, double time) {
    return Eigen::Vector4d(0.5 * time, 4.0 * row, 0.5, 0.0);
  };
  for (double time = 0.0; time <= 6.0; time += 0.5) {
    const double off = std::max(0.0, 0.8 - 0.4 * time);
    for (int id : {1, 2}) {
      fusion.add(estimate(1, id, time, abreast(id, time)));
      fusion.add(estimate(2, id, time, abreast(id == 1 ? 1.0 + off : 2.0 - off, time)));
    }
    tracks = fusion.update(core::microseconds(time));
  }
  ASSERT_EQ(tracks.size(), 2u);
  for (int id : {1, 2}) EXPECT_EQ(fusion.global_of(2, id), fusion.global_of(1, id));
  EXPECT_NEAR((tracks[0].state - abreast(1.0, 6.0)).norm(), 0.0, 1e-6);
}

}  // namespace
}  // namespace lookout::fusion
