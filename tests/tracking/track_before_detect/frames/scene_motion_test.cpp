#include "tracking/track_before_detect/frames/scene_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::tracking {
namespace {

constexpr int kColumns = 90;
constexpr int kRows = 70;

/// A smooth scene moved by (dx, dy), with a spot at (x, y) that does not belong to it.
std::vector<double> scene(double dx, double dy, double x, double y) {
  std::vector<double> grey;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const double u = column - dx, v = row - dy;
      const double spot = 60.0 * std::exp(-0.5 * ((column - x) * (column - x) + (row - y) * (row - y)));
      grey.push_back(100.0 + 30.0 * std::sin(0.23 * u) * std::cos(0.31 * v) +
                     15.0 * std::sin(0.11 * u + 0.17 * v) + spot);
    }
  return grey;
}

TEST(SceneMotion, TheShiftIsFoundToAFractionOfAPixel) {
  const Eigen::Vector2d shift =
      scene_shift(scene(0, 0, -50, -50), scene(2.4, -1.3, -50, -50), kColumns, kRows);
  EXPECT_NEAR(shift.x(), 2.4, 0.1);
  EXPECT_NEAR(shift.y(), -1.3, 0.1);
}

TEST(SceneMotion, WhatStandsInAMovingSceneIsWhatIsLeft) {
  const auto rest = scene_residual(scene(0, 0, 40, 30), scene(3, 0, 40, 30), kColumns, kRows);
  std::size_t highest = 0;
  for (std::size_t i = 0; i < rest.size(); ++i)
    if (rest[i] > rest[highest]) highest = i;
  EXPECT_NEAR(static_cast<double>(highest % kColumns), 40.0, 1.0);
  EXPECT_NEAR(static_cast<double>(highest / kColumns), 30.0, 1.0);
}

TEST(SceneMotion, AFrameTooSmallToCompareHasNoMotion) {
  const std::vector<double> small(36, 1.0);
  EXPECT_EQ(scene_shift(small, small, 6, 6), Eigen::Vector2d(0, 0));
}

}  // namespace
}  // namespace lookout::tracking
