#include "tracking/initiation/lines/sparse_accumulator.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

TEST(SparseAccumulator, SumsVotesOfACell) {
  SparseAccumulator votes;
  votes.add(7, 1.0);
  votes.add(1'000'000'007, 0.5);
  votes.add(7, 2.0);
  EXPECT_DOUBLE_EQ(votes.value(7), 3.0);
  EXPECT_DOUBLE_EQ(votes.value(1'000'000'007), 0.5);
  EXPECT_DOUBLE_EQ(votes.value(8), 0.0);
  EXPECT_EQ(votes.entries().size(), 2u);
}

TEST(SparseAccumulator, AStepRaisesACellByItsLargestVoteAlone) {
  SparseAccumulator votes;
  votes.raise(3, 0, 0.4);
  votes.raise(3, 0, 0.9);
  votes.raise(3, 1, 0.5);
  votes.raise(3, 1, 0.2);
  EXPECT_DOUBLE_EQ(votes.value(3), 1.4);
}

TEST(SparseAccumulator, GrowsAndForgetsEverythingWhenCleared) {
  SparseAccumulator votes;
  for (int round = 0; round < 3; ++round) {
    const int count = round == 1 ? 10 : 5000;  // The few after the many free their own slots.
    for (int key = 0; key < count; ++key) votes.add(key * 1720, key);
    for (int key = 0; key < count; ++key) EXPECT_DOUBLE_EQ(votes.value(key * 1720), key);
    votes.clear();
    EXPECT_TRUE(votes.entries().empty());
    EXPECT_DOUBLE_EQ(votes.value(1720), 0.0);
  }
}

}  // namespace
}  // namespace lookout::tracking
