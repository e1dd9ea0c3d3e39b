#include "tracking/track_before_detect/images/wide_level.hpp"

#include <gtest/gtest.h>

namespace lookout::tracking {
namespace {

constexpr int kBins = 12;
constexpr float kPrior = 1.0f;
constexpr float kRing = 5.0f;  // over the usual level

/// A memory of 50 pings that hold kRing times the usual level at bin 6 of the beams from `first` to before
/// `last`.
LevelMemory memory_of(int beams, int first, int last) {
  LevelMemory memory;
  memory.begin(static_cast<std::size_t>(beams * kBins));
  for (int ping = 0; ping < 50; ++ping)
    for (int beam = 0; beam < beams; ++beam)
      for (int bin = 0; bin < kBins; ++bin)
        memory.learn(static_cast<std::size_t>(beam * kBins + bin),
                     bin == 6 && beam >= first && beam < last ? kRing : 1.0f, {});
  return memory;
}

float at_ring(int beams, int beam, int first, int last) {
  WideLevel wide;
  wide.begin(kBins, beams);
  wide.update(memory_of(beams, first, last), kPrior);
  EXPECT_FLOAT_EQ(wide.at(5, beam), 1.0f);
  return wide.at(6, beam);
}

// The mean of a prior ping at 1 and 50 at 5; rates of 100 pings.
TEST(WideLevel, HoldsARingAndNoCompactEcho) {
  const float learnt = (kPrior + 50.0f * kRing) / (kPrior + 50.0f);
  EXPECT_NEAR(at_ring(64, 30, 0, 64), learnt, 1e-4);
  EXPECT_FLOAT_EQ(at_ring(64, 30, 28, 32), 1.0f);
}

TEST(WideLevel, TheBordersOfTheFanAreLikeItsMiddle) {
  EXPECT_GT(at_ring(64, 0, 0, 20), 4.0f);
  EXPECT_GT(at_ring(64, 63, 44, 64), 4.0f);
  EXPECT_FLOAT_EQ(at_ring(64, 63, 60, 64), 1.0f);
}

TEST(WideLevel, AWindowIsAnEighthOfAWideFan) {
  EXPECT_FLOAT_EQ(at_ring(512, 200, 194, 209), 1.0f);
  EXPECT_GT(at_ring(512, 200, 160, 240), 4.0f);
}

// An echo of 12 beams between its nulls is background of a window of 17, as a ring's part is, and none of one
// of 4 x 13 + 1.
TEST(WideLevel, AWindowIsFourTimesTheEchoOfAPoint) {
  WideLevel wide;
  wide.begin(kBins, 128);
  wide.update(memory_of(128, 58, 70), kPrior);
  EXPECT_GT(wide.at(6, 64), 4.0f);
  wide.widen(12.0);
  wide.update(memory_of(128, 58, 70), kPrior);
  wide.update(memory_of(128, 58, 70), kPrior);
  EXPECT_FLOAT_EQ(wide.at(6, 64), 1.0f);
}

TEST(WideLevel, AFanNarrowerThanTheWindowHasOneLevel) {
  EXPECT_GT(at_ring(9, 0, 0, 9), 4.0f);
  EXPECT_FLOAT_EQ(at_ring(9, 0, 0, 2), 1.0f);
}

TEST(WideLevel, EachBinHasItsTurn) {
  WideLevel wide;
  wide.begin(kBins, 32);
  for (int ping = 0; ping < 12; ++ping) wide.update(memory_of(32, 0, 0), kPrior);
  const LevelMemory ring = memory_of(32, 0, 32);
  for (int ping = 0; ping < 4; ++ping) wide.update(ring, kPrior);
  EXPECT_GT(wide.at(6, 10), 4.0f);
}

}  // namespace
}  // namespace lookout::tracking
