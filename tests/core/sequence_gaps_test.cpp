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

}  // namespace
}  // namespace lookout::core
