#include "tracking/track_before_detect/images/memory_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lookout::tracking {
namespace {

const float kPrior = 1.0f / (1.0f + std::exp(-2.0f));  // most of what stands does so on the earth
constexpr int kColumns = 32;                           // two blocks

/// Pings that hold three times the usual level in the first block, which one memory foretells, and the usual
/// level in the second, where the other memory expects three times that.
void show(MemoryChoice& choice, bool moved_knows) {
  std::vector<float> ratio(kColumns, 1.0f), knows(kColumns, 1.0f), ignorant(kColumns, 1.0f);
  for (int column = 0; column < kColumns / 2; ++column)
    ratio[static_cast<std::size_t>(column)] = knows[static_cast<std::size_t>(column)] = 3.0f;
  for (int ping = 0; ping < 10; ++ping) {
    for (int row = 0; row < 16; ++row)
      choice.add(row, ratio.data(), (moved_knows ? knows : ignorant).data(),
                 (moved_knows ? ignorant : knows).data());
    choice.settle();
  }
}

TEST(MemoryChoice, BelievesTheMemoryThatForetellsAndOnlyThere) {
  MemoryChoice choice;
  choice.begin(kColumns, 16);
  show(choice, true);
  EXPECT_GT(choice.share(3, 3), 0.99f);
  EXPECT_FLOAT_EQ(choice.share(20, 3), kPrior);  // both say the same there
  choice.begin(kColumns, 16);
  EXPECT_FLOAT_EQ(choice.share(3, 3), kPrior);
  show(choice, false);
  EXPECT_LT(choice.share(3, 3), 0.01f);
}

TEST(MemoryChoice, TheGreaterLevelCountsUntilItIsShownToBeWrong) {
  MemoryChoice choice;
  choice.begin(kColumns, 16);
  EXPECT_FLOAT_EQ(choice.level(3, 3, 5.0f, 2.0f), 5.0f);
  // The memory that is the less likely one, share .12: sqrt(1 - ln(1 / .12) / ln(1e4)) of its level, over the
  // same of the other's share, .88.
  EXPECT_NEAR(choice.level(3, 3, 2.0f, 5.0f), 5.0f * 0.878f / 0.993f, 0.01f);
  show(choice, false);
  EXPECT_FLOAT_EQ(choice.level(3, 3, 5.0f, 2.0f), 2.0f);
}

TEST(MemoryChoice, AShadowOnABeamIsJudgedApartFromTheBeamsBeside) {
  MemoryChoice choice;
  choice.begin(kColumns, 16);
  const std::vector<float> one(kColumns, 1.0f), two(kColumns, 2.0f);
  for (int ping = 0; ping < 10; ++ping) {
    for (int row = 0; row < 16; ++row) choice.add(row, (row < 4 ? two : one).data(), two.data(), one.data());
    choice.settle();
  }
  EXPECT_FLOAT_EQ(choice.level(3, 3, 2.0f, 1.0f), 2.0f);
  EXPECT_FLOAT_EQ(choice.level(3, 4, 2.0f, 1.0f), 1.0f);
}

}  // namespace
}  // namespace lookout::tracking
