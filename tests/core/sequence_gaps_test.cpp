#include "core/sequence_gaps.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace lookout::core {
namespace {

using Step = SequenceGaps::Step;

TEST(SequenceGaps, CountsWhatIsSkipped) {
  SequenceGaps gaps;
  EXPECT_EQ(gaps.add(7), Step::in_order);
  EXPECT_EQ(gaps.add(8), Step::in_order);
  EXPECT_EQ(gaps.add(8), Step::repeated);
  EXPECT_EQ(gaps.add(11), Step::gap);
  EXPECT_EQ(gaps.lost(), 2);
}

TEST(SequenceGaps, TakesBackwardsAndFarAheadAsRestart) {
  SequenceGaps gaps;
  gaps.add(10);
  EXPECT_EQ(gaps.add(0), Step::restart);
  EXPECT_EQ(gaps.add(std::numeric_limits<std::int64_t>::max()), Step::restart);
  EXPECT_EQ(gaps.add(std::numeric_limits<std::int64_t>::min()), Step::restart);
  EXPECT_EQ(gaps.lost(), 0);
  EXPECT_EQ(gaps.restarts(), 3);
}

std::int64_t lost_of(std::initializer_list<std::int64_t> numbers) {
  SequenceGaps gaps;
  for (const std::int64_t number : numbers) gaps.add(number);
  return gaps.lost();
}

TEST(SequenceGaps, TakesBackOneNumberThatFitsNowhere) {
  EXPECT_EQ(lost_of({0, 1, 90'000, 3, 4}), 0);  // 2 with a damaged counter.
  EXPECT_EQ(lost_of({0, 1, 2, 0, 3, 4}), 0);    // 0 again, late.
  EXPECT_EQ(lost_of({0, 1, 5, 6, 7}), 3);       // A loss stays one.
}

TEST(SequenceGaps, WhatComesLateIsNotLost) {
  EXPECT_EQ(lost_of({1, 2, 4, 3, 5, 6}), 0);
  EXPECT_EQ(lost_of({1, 2, 6, 4, 3, 7, 12, 5, 9, 13}), 3);  // 8, 10 and 11.
  EXPECT_EQ(lost_of({1, 5, 3, 3, 6}), 2);                   // 3 comes twice, 2 and 4 never.
}

// A thousand too high for a while: nothing between came, and going back is a restart.
TEST(SequenceGaps, NumbersThatJumpAndComeBackAreNotLate) {
  SequenceGaps gaps;
  for (const std::int64_t number : {78, 79, 1080, 1081, 1082, 83, 84, 85}) gaps.add(number);
  EXPECT_EQ(gaps.lost(), 1000);
  EXPECT_EQ(gaps.restarts(), 1);
}

TEST(SequenceGaps, NumbersOfAnOldLineAreNoneOfTheNew) {
  SequenceGaps gaps;
  for (const std::int64_t number : {5, 6, 9, 10, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9}) gaps.add(number);
  EXPECT_EQ(gaps.lost(), 2);  // 7 and 8 before the restart.
  EXPECT_EQ(gaps.restarts(), 1);
}

// Every second is late by more than one gap, as on a link of two ways, and refused.
TEST(SequenceGaps, WhatIsRefusedGapsLaterIsNotLost) {
  SequenceGaps gaps;
  for (std::int64_t number = 0; number < 100; number += 2) {
    gaps.add(number);
    if (number >= 10) gaps.refused(number - 9);
  }
  EXPECT_EQ(gaps.lost(), 4);  // 91, 93, 95 and 97 are still to come.
}

TEST(SequenceGaps, ARefusedDoubleIsFoundOnce) {
  SequenceGaps gaps;
  gaps.add(0);
  gaps.add(4);
  for (int times = 0; times < 3; ++times) gaps.refused(2);
  EXPECT_EQ(gaps.lost(), 2);
}

TEST(SequenceGaps, DoesNotCountWhatCameAndWasRefused) {
  SequenceGaps gaps;
  gaps.add(0);
  gaps.refused(1);  // Before the gap is seen, and
  gaps.add(4);
  EXPECT_EQ(gaps.lost(), 2);
  gaps.refused(3);  // after.
  EXPECT_EQ(gaps.lost(), 1);
}

}  // namespace
}  // namespace lookout::core
