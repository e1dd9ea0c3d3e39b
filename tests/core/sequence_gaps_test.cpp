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
