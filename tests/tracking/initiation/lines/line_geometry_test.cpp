#include "tracking/initiation/lines/line_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lookout::tracking {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(LineGeometry, VerticalAndHorizontalLinesAreExact) {
  const auto vertical = line_through({-3.0, 1.0}, {-3.0, 8.0});
  ASSERT_TRUE(vertical);
  EXPECT_DOUBLE_EQ(vertical->theta, 0.0);
  EXPECT_DOUBLE_EQ(vertical->rho, -3.0);
  const auto horizontal = line_through({5.0, 7.0}, {-2.0, 7.0});
  ASSERT_TRUE(horizontal);
  EXPECT_DOUBLE_EQ(horizontal->theta, kPi / 2);
  EXPECT_DOUBLE_EQ(horizontal->rho, 7.0);
}

/// The line of target 2 of [Fan2018] Table 1 with the printed signs; its rho is negative, docs/initiators.md,
/// Errata.
TEST(LineGeometry, KeepsTheSignOfRho) {
  const auto line = line_through({3000.0, 300.0}, {3000.0 - 173.2, 300.0 - 100.0});
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->theta, 120.0 * kPi / 180.0, 1e-4);
  EXPECT_NEAR(line->rho, -1240.0, 1.0);
}

TEST(LineGeometry, BothOrdersOfAPairGiveOneLineInEveryOctant) {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double heading = degrees * kPi / 180.0;
    const Eigen::Vector2d p(120.0, -340.0);
    const Eigen::Vector2d q = p + 50.0 * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    const NormalLine line = *line_through(p, q);
    const NormalLine apart = line_difference(*line_through(q, p), line);
    EXPECT_GE(line.theta, 0.0);
    EXPECT_LT(line.theta, kPi);
    EXPECT_NEAR(line.offset_of(p), 0.0, 1e-9) << degrees;
    EXPECT_NEAR(line.offset_of(q), 0.0, 1e-9) << degrees;
    EXPECT_NEAR(apart.theta, 0.0, 1e-12) << degrees;
    EXPECT_NEAR(apart.rho, 0.0, 1e-9) << degrees;
  }
}

TEST(LineGeometry, CoincidingPointsGiveNoLine) {
  EXPECT_FALSE(line_through({2.0, 3.0}, {2.0, 3.0}));
}

TEST(LineGeometry, FoldingThetaFlipsRho) {
  const NormalLine folded = canonical({4.0, -0.1});
  EXPECT_DOUBLE_EQ(folded.rho, -4.0);
  EXPECT_DOUBLE_EQ(folded.theta, kPi - 0.1);
  EXPECT_DOUBLE_EQ(canonical({4.0, 2.0 * kPi + 0.1}).rho, 4.0);
}

TEST(LineGeometry, DifferenceLooksOverTheWrap) {
  const NormalLine apart = line_difference({-5.0, 0.01}, {4.0, kPi - 0.01});
  EXPECT_NEAR(apart.theta, 0.02, 1e-12);
  EXPECT_NEAR(apart.rho, 1.0, 1e-12);
}

}  // namespace
}  // namespace lookout::tracking
