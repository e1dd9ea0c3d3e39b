#include "tracking/track_before_detect/images/level_memory.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

constexpr MemoryRates kRates{100.0f, 0.5f};

LevelMemory two_cells() {
  LevelMemory memory;
  memory.begin(2);
  return memory;
}

TEST(LevelMemory, AverageOfWhatWasHeldWithThePriorAtOne) {
  LevelMemory memory = two_cells();
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f), 1.0f);
  for (int ping = 0; ping < 6; ++ping) memory.learn(0, 3.0f, kRates);
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f), 2.0f);  // (6 * 1 + 6 * 3) / 12
  EXPECT_FLOAT_EQ(memory.level(1, 6.0f), 1.0f);
}

TEST(LevelMemory, WhatIsKeptIsNotLearntUntilItStands) {
  LevelMemory memory = two_cells();
  memory.keep(0, 4.0f, kRates);
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f), 1.0f);
  memory.stand(0, 4.0f, kRates);  // swift memory 0 -> 2 -> 3, which then counts for 100 pings
  EXPECT_NEAR(memory.level(0, 6.0f), (6.0f + 100.0f * 3.0f) / 106.0f, 1e-5);
}

TEST(LevelMemory, WhatIsKeptTooLongIsLearnt) {
  LevelMemory memory = two_cells();
  const MemoryRates rates{100.0f, 0.5f, 4.0f};
  for (int ping = 0; ping < 10; ++ping) memory.keep(0, 3.0f, rates);
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f), 2.0f);  // six of ten pings
}

TEST(LevelMemory, MovesWithItsCellsAndKnowsNothingOfNewOnes) {
  LevelMemory memory = two_cells();
  for (int ping = 0; ping < 6; ++ping) memory.learn(0, 3.0f, kRates);
  memory.move({LevelMemory::kNew, 0});
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f), 1.0f);
  EXPECT_FLOAT_EQ(memory.level(1, 6.0f), 2.0f);
}

}  // namespace
}  // namespace lookout::tracking
