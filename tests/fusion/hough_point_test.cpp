#include "fusion/hough_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lookout::fusion {
namespace {

constexpr double kPi = std::numbers::pi;
const Eigen::Vector2d kOrigin{0.0, 0.0};

TEST(HoughPoint, AgreesWithThePrintedSlopeForm) {
  const Eigen::Vector2d older(100.0, 50.0), newer(300.0, 150.0);
  const double slope = 0.5;
  const auto point = hough_point(older, newer, kOrigin);
  ASSERT_TRUE(point);
  // [Li2018] Eq. (4), (5).
  EXPECT_NEAR(point->rho, std::abs(slope * 300.0 - 150.0) / std::sqrt(slope * slope + 1.0), 1e-9);
  EXPECT_NEAR(point->theta, std::atan(-1.0 / slope), 1e-12);
}

TEST(HoughPoint, IsFiniteOnBothAxes) {
  // Along x at y = 7, and along y at x = 7: at distance 7 from the origin by construction.
  const auto along_x = hough_point({0.0, 7.0}, {5.0, 7.0}, kOrigin);
  const auto along_y = hough_point({7.0, 0.0}, {7.0, 5.0}, kOrigin);
  ASSERT_TRUE(along_x && along_y);
  EXPECT_NEAR(along_x->rho, 7.0, 1e-12);
  EXPECT_NEAR(along_y->rho, 7.0, 1e-12);
  EXPECT_NEAR(along_x->theta, -kPi / 2, 1e-12);
  EXPECT_NEAR(along_y->theta, 0.0, 1e-12);
}

TEST(HoughPoint, HasNoLineForAStandingTarget) {
  EXPECT_FALSE(hough_point({3.0, 4.0}, {3.0, 4.0}, kOrigin));
}

// The flaws of the printed map, docs/fusion.md, kept on purpose in `sdf` and shown here.

TEST(HoughPoint, FoldsMirroredLinesOnOnePoint) {
  const auto above = hough_point({0.0, 100.0}, {1.0, 101.0}, kOrigin);
  const auto below = hough_point({0.0, -100.0}, {1.0, -99.0}, kOrigin);
  ASSERT_TRUE(above && below);
  EXPECT_NEAR(above->rho, 100.0 / std::numbers::sqrt2, 1e-9);  // 70.7, docs/fusion.md, flaw 4.
  EXPECT_NEAR(hough_distance(*above, *below, 1.0), 0.0, 1e-9);
}

TEST(HoughPoint, JumpsWhereTheNormalCrossesTheEndOfItsAxis) {
  const auto left = hough_point({0.0, 1.0}, {1.0, 1.001}, kOrigin);
  const auto right = hough_point({0.0, 1.0}, {1.0, 0.999}, kOrigin);
  ASSERT_TRUE(left && right);
  EXPECT_GT(std::abs(left->theta - right->theta), kPi - 0.01);
}

TEST(HoughPoint, LeverArmTurnsHeadingJitterIntoDistance) {
  // A heading jitter of 14 m over a tracklet of 566 m moves rho by about 13,700 * 14 / 566 = 339 m;
  // docs/fusion.md, flaw 2.
  const Eigen::Vector2d older(9300.0, 10000.0);
  const auto straight = hough_point(older, older + Eigen::Vector2d(400.0, -400.0), kOrigin);
  const auto jittered = hough_point(older, older + Eigen::Vector2d(409.9, -390.1), kOrigin);
  ASSERT_TRUE(straight && jittered);
  EXPECT_LT(std::abs(straight->rho - jittered->rho), 20.0);  // Course across the lever arm: harmless.
  const auto radial = hough_point(older, older + Eigen::Vector2d(400.0, 400.0), kOrigin);
  const auto radial_jittered = hough_point(older, older + Eigen::Vector2d(409.9, 390.1), kOrigin);
  ASSERT_TRUE(radial && radial_jittered);
  EXPECT_NEAR(std::abs(radial->rho - radial_jittered->rho), 339.0, 10.0);
}

}  // namespace
}  // namespace lookout::fusion
