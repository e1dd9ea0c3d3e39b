#include "csht/likelihood/frame_counts.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::csht {
namespace {

constexpr FrameCounts::Border kInside{};

// One return in each unit of area of the frame's sides: as many as the area has.
TEST(FrameCounts, EvenClutterCountsByItsArea) {
  FrameCounts frame;
  for (double across = -5.5; across < 6.0; across += 1.0)
    for (double along = -1.75; along < 2.0; along += 0.5) frame.take(across, along, 0.5, true);
  EXPECT_NEAR(frame.beside(kInside), FrameCounts::kBesideArea, 1e-9);
  EXPECT_NEAR(frame.around(kInside), FrameCounts::kAroundArea, 1e-9);
}

TEST(FrameCounts, TheMiddleDoesNotCount) {
  FrameCounts frame;
  for (int k = 0; k < 100; ++k) frame.take(0.3, -0.4, 1.0, k % 2 == 0);
  EXPECT_EQ(frame.beside(kInside), 0.0);
  EXPECT_EQ(frame.around(kInside), 0.0);
}

// 36 returns on the left before, 36 on the right after: of either only the root of 36 counts.
TEST(FrameCounts, ATrailDoesNotCount) {
  FrameCounts frame;
  for (int k = 0; k < 36; ++k) {
    frame.take(-4.0, 0.0, 1.0, true);
    frame.take(4.0, 0.0, 1.0, false);
  }
  EXPECT_NEAR(frame.beside(kInside), 2.0 * 6.0, 1e-9);
}

// An end has half of the area of a side.
TEST(FrameCounts, TheRichestSideCountsByItsArea) {
  FrameCounts frame;
  for (int k = 0; k < 36; ++k) frame.take(-4.0, 0.0, 1.0, k % 2 == 0);
  EXPECT_NEAR(frame.richest(), 36.0, 1e-9);
  for (int k = 0; k < 20; ++k) frame.take(0.0, 1.5, 1.0, true);
  EXPECT_NEAR(frame.richest(), 20.0 * FrameCounts::kBesideArea / FrameCounts::kAroundArea, 1e-9);
}

TEST(FrameCounts, AtTheBorderOneSideStandsForBoth) {
  FrameCounts frame;
  for (int k = 0; k < 36; ++k) frame.take(-4.0, 0.0, 1.0, true);
  EXPECT_NEAR(frame.beside({.right = true}), 72.0, 1e-9);
  EXPECT_NEAR(frame.beside(kInside), 6.0, 1e-9);
}

}  // namespace
}  // namespace lookout::csht
