#include "fusion/pairings.hpp"

#include <gtest/gtest.h>

#include "tests/fusion/test_nodes.hpp"

namespace lookout::fusion {
namespace {

constexpr std::int64_t kTrack = 7, kOther = 8;

/// A local track that has sent `messages`, half a second apart.
LocalTrack heard(int messages) {
  LocalTrack track(testing::estimate(2, 1, 0.0, {0, 0, 1, 0}));
  for (int k = 1; k < messages; ++k) track.append(testing::estimate(2, 1, 0.5 * k, {0, 0, 1, 0}));
  return track;
}

TEST(Pairings, ATrackWithoutAnotherVoiceIsVotedForAtOnce) {
  Pairings pairings(3);
  EXPECT_TRUE(pairings.pair(heard(2), kTrack, false));
  EXPECT_EQ(pairings.voted_for(heard(2)), kTrack);
}

TEST(Pairings, ANewcomerVotesWithItsThirdMessageForTheSameTrack) {
  Pairings pairings(3);
  EXPECT_FALSE(pairings.pair(heard(2), kTrack, true));
  EXPECT_FALSE(pairings.pair(heard(2), kTrack, true));  // The same message again proves nothing.
  EXPECT_EQ(pairings.global_of(heard(2).key()), kTrack);
  EXPECT_EQ(pairings.voted_for(heard(2)), -1);
  EXPECT_FALSE(pairings.pair(heard(3), kTrack, true));
  EXPECT_TRUE(pairings.pair(heard(4), kTrack, true));
  EXPECT_EQ(pairings.voted_for(heard(4)), kTrack);
}

TEST(Pairings, AChangeOfMindBeginsTheProbationAnew) {
  Pairings pairings(3);
  for (int messages : {2, 3}) EXPECT_FALSE(pairings.pair(heard(messages), kTrack, true));
  for (int messages : {4, 5}) EXPECT_FALSE(pairings.pair(heard(messages), kOther, true));
  EXPECT_TRUE(pairings.pair(heard(6), kOther, true));
}

TEST(Pairings, AVoteOnceGivenStaysWhenOthersCome) {
  Pairings pairings(3);
  pairings.pair(heard(2), kTrack, false);
  EXPECT_TRUE(pairings.pair(heard(3), kTrack, true));
}

TEST(Pairings, ATrackThatBeganAgainHasNoPast) {
  Pairings pairings(3);
  pairings.pair(heard(9), kTrack, false);
  EXPECT_EQ(pairings.voted_for(heard(2)), -1);
  EXPECT_FALSE(pairings.pair(heard(2), kTrack, true));
}

TEST(Pairings, FollowsAMergerAndForgets) {
  Pairings pairings(3);
  pairings.pair(heard(2), kOther, false);
  pairings.rename(kOther, kTrack);
  EXPECT_EQ(pairings.voted_for(heard(2)), kTrack);
  pairings.forget_unknown({});
  EXPECT_EQ(pairings.global_of(heard(2).key()), -1);
}

}  // namespace
}  // namespace lookout::fusion
