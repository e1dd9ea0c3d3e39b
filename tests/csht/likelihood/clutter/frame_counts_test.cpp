#include "csht/likelihood/clutter/frame_counts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lookout::csht {
namespace {

constexpr FrameCounts::Border kInside{};

void take(FrameCounts& frame, double across, double along, double weight, bool before) {
  frame.take(FrameCounts::cell_of(static_cast<float>(across), static_cast<float>(along), before ? 1 : 0),
             weight);
}

// One return in each unit of area of the frame's sides: as many as the area has.
TEST(FrameCounts, EvenClutterCountsByItsArea) {
  FrameCounts frame;
  for (double across = -5.5; across < 6.0; across += 1.0)
    for (double along = -1.75; along < 2.0; along += 0.5) take(frame, across, along, 0.5, true);
  EXPECT_NEAR(frame.beside(kInside), FrameCounts::kBesideArea, 1e-9);
  EXPECT_NEAR(frame.around(kInside), FrameCounts::kAroundArea, 1e-9);
  EXPECT_NEAR(frame.slanting(kInside), FrameCounts::kBesideArea, 1e-9);
}

TEST(FrameCounts, TheMiddleDoesNotCount) {
  FrameCounts frame;
  for (int k = 0; k < 100; ++k) take(frame, 0.3, -0.4, 1.0, k % 2 == 0);
  EXPECT_EQ(frame.beside(kInside), 0.0);
  EXPECT_EQ(frame.around(kInside), 0.0);
}

// 36 returns on the left before, 36 on the right after: of either only the root of 36 counts.
TEST(FrameCounts, ATrailDoesNotCount) {
  FrameCounts frame;
  for (int k = 0; k < 36; ++k) {
    take(frame, -4.0, 0.0, 1.0, true);
    take(frame, 4.0, 0.0, 1.0, false);
  }
  EXPECT_NEAR(frame.beside(kInside), 2.0 * 6.0, 1e-9);
}

// A bottom that comes 1.5 reaches nearer in the 4 beams to the middle of a side: level with the place neither
// side has any of it.
TEST(FrameCounts, WhatSlantsCountsInTheWindowsWhereItIs) {
  FrameCounts frame;
  for (int k = 0; k < 36; ++k) {
    take(frame, -4.0, 1.5, 1.0, k % 2 == 0);
    take(frame, 4.0, -1.5, 1.0, k % 2 == 0);
  }
  EXPECT_EQ(frame.beside(kInside), 0.0);
  EXPECT_NEAR(frame.slanting(kInside), 72.0, 1e-9);
}

TEST(FrameCounts, WhatBendsCountsInTheWindowsWhereItIs) {
  FrameCounts frame;
  for (int k = 0; k < 36; ++k)
    for (const double across : {-4.0, 4.0}) take(frame, across, 1.5, 1.0, k % 2 == 0);
  EXPECT_EQ(frame.beside(kInside), 0.0);
  EXPECT_NEAR(frame.slanting(kInside), 72.0, 1e-9);
  EXPECT_NEAR(frame.slanting({.left = true}), 72.0, 1e-9);
}

// 36 returns to the left and nearer before, 36 to the right and farther after.
TEST(FrameCounts, ATrailDoesNotCountAsSlanting) {
  FrameCounts frame;
  for (int k = 0; k < 36; ++k) {
    take(frame, -4.0, -1.5, 1.0, true);
    take(frame, 4.0, 1.5, 1.0, false);
  }
  EXPECT_NEAR(frame.slanting(kInside), 2.0 * 6.0, 1e-9);
}

// An end has half of the area of a side.
TEST(FrameCounts, TheRichestSideCountsByItsArea) {
  FrameCounts frame;
  for (int k = 0; k < 36; ++k) take(frame, -4.0, 0.0, 1.0, k % 2 == 0);
  EXPECT_NEAR(frame.richest(), 36.0, 1e-9);
  for (int k = 0; k < 20; ++k) take(frame, 0.0, 1.5, 1.0, true);
  EXPECT_NEAR(frame.richest(), 20.0 * FrameCounts::kBesideArea / FrameCounts::kAroundArea, 1e-9);
}

TEST(FrameCounts, AtTheBorderOneSideStandsForBoth) {
  FrameCounts frame;
  for (int k = 0; k < 36; ++k) take(frame, -4.0, 0.0, 1.0, true);
  EXPECT_NEAR(frame.beside({.right = true}), 72.0, 1e-9);
  EXPECT_NEAR(frame.beside(kInside), 6.0, 1e-9);
}

// Left alone has ten times what the background brings: a corner, where the place counts, up to that side.
TEST(FrameExcess, AtACornerThePlaceCountsUpToItsRichestSide) {
  FrameCounts frame;
  for (int k = 0; k < 80; ++k) take(frame, -4.0, 0.0, 1.0, k % 2 == 0);
  const double per_area = 8.0 / (0.5 * FrameCounts::kBesideArea);
  const FrameExcess found(frame, kInside, per_area, {.share = 0.2, .shape = 2.0, .mean = 1.0});
  EXPECT_TRUE(found.is_corner());
  EXPECT_LT(found.both().density(), 4.0);
  EXPECT_EQ(found.with_corner({1.0, 5.0}).density(), std::max(4.0, found.both().density()));
  EXPECT_NEAR(found.with_corner({1.0, 50.0}).density(), 7.2, 0.01);  // (80 + 2) / (8 + 2) - 1
}

// Ten times what the background brings, a reach nearer to the left and a reach farther to the right.
TEST(FrameExcess, WhatSlantsIsDense) {
  FrameCounts frame;
  for (int k = 0; k < 80; ++k) {
    take(frame, -4.0, -1.5, 1.0, k % 2 == 0);
    take(frame, 4.0, 1.5, 1.0, k % 2 == 0);
  }
  const double per_area = 8.0 / (0.5 * FrameCounts::kBesideArea);
  const FrameExcess found(frame, kInside, per_area, {.share = 0.2, .shape = 2.0, .mean = 1.0});
  EXPECT_NEAR(found.both().density(), 8.0, 0.01);  // (160 + 2) / (16 + 2) - 1
}

TEST(FrameCounts, BeyondTheFanAndTheRangeIsNothing) {
  ScanTable scan;
  scan.num_beams = 90;
  const auto border = FrameCounts::border_at(scan, 43.0, 1.0, 30.0);
  EXPECT_TRUE(border.right && border.near);
  EXPECT_FALSE(border.left || border.far);
}

}  // namespace
}  // namespace lookout::csht
