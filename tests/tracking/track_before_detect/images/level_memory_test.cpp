#include "tracking/track_before_detect/images/level_memory.hpp"

#include <gtest/gtest.h>

#include <vector>

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
  memory.keep(0, 4.0f, 100.0f, kRates);
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f), 1.0f);
  memory.stand(0, 4.0f, kRates);  // swift memory 0 -> 2 -> 3, which then counts for 100 pings
  EXPECT_NEAR(memory.level(0, 6.0f), (6.0f + 100.0f * 3.0f) / 106.0f, 1e-5);
}

TEST(LevelMemory, WhatIsKeptTooLongIsLearntWithAllThatItHeld) {
  LevelMemory memory = two_cells();
  for (int ping = 0; ping < 4; ++ping) memory.keep(0, 3.0f, 4.0f, kRates);
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f), 1.0f);
  for (int ping = 4; ping < 10; ++ping) memory.keep(0, 3.0f, 4.0f, kRates);
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f), 2.25f);  // (6 * 1 + 10 * 3) / 16
}

// One track after another on a thing that stands: a ping without one is no new beginning.
TEST(LevelMemory, APingThatIsFreeTakesOneOffWhatWasKept) {
  LevelMemory memory = two_cells();
  for (int ping = 0; ping < 4; ++ping) memory.keep(0, 3.0f, 4.0f, kRates);
  memory.learn(0, 3.0f, kRates);
  memory.keep(0, 3.0f, 4.0f, kRates);
  memory.keep(0, 3.0f, 4.0f, kRates);            // the fifth
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f), 2.0f);  // (6 * 1 + 1 * 3 + 5 * 3) / 12
}

TEST(LevelMemory, OfWhatIsNewTheUsualLevelIsExpected) {
  LevelMemory memory = two_cells();
  for (int ping = 0; ping < 6; ++ping) memory.learn(0, 3.0f, kRates);
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f, 5.0f), 4.0f);
  EXPECT_FLOAT_EQ(memory.level(1, 6.0f, 5.0f), 5.0f);
}

TEST(LevelMemory, MovesWithItsCellsAndKnowsNothingOfNewOnes) {
  LevelMemory memory = two_cells();
  for (int ping = 0; ping < 6; ++ping) memory.learn(0, 3.0f, kRates);
  memory.move({{-1.0f, 0.0f}, {0.0f, 0.0f}}, 2);
  EXPECT_FLOAT_EQ(memory.level(0, 6.0f), 1.0f);
  EXPECT_FLOAT_EQ(memory.level(1, 6.0f), 2.0f);
}

// Each move is to whole cells; what is left over must not add up: a random walk would be off by 1.6 cells.
TEST(LevelMemory, ManyMovesByPartsOfACellKeepThePlace) {
  constexpr int kColumns = 40, kMoves = 30;
  constexpr float kStep = 0.3f;
  LevelMemory memory;
  memory.begin(kColumns);
  for (int ping = 0; ping < 20; ++ping) memory.learn(5, 9.0f, kRates);
  std::vector<Eigen::Vector2f> from;
  for (int column = 0; column < kColumns; ++column)
    from.emplace_back(static_cast<float>(column) - kStep, 0.0f);
  for (int move = 1; move <= kMoves; ++move) {
    memory.move(from, kColumns);
    std::size_t brightest = 0;
    for (std::size_t cell = 1; cell < kColumns; ++cell)
      if (memory.level(cell, 6.0f) > memory.level(brightest, 6.0f)) brightest = cell;
    EXPECT_NEAR(static_cast<float>(brightest), 5.0f + kStep * static_cast<float>(move), 0.51f) << move;
  }
}

}  // namespace
}  // namespace lookout::tracking
