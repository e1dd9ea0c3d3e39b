#include "csht/likelihood/clutter/place_counts.hpp"

#include <gtest/gtest.h>

namespace lookout::csht {
namespace {

TEST(PlaceCounts, TakeAReturnByItsWeightAndItsFreeShare) {
  TwoCounts counts;
  counts.take({.weight = 0.5F, .free = 0.25F}, 2.0);
  EXPECT_EQ(counts.all, 1.0);
  EXPECT_EQ(counts.free, 0.25);
}

// By hand: areas under a triangle of height 1.
TEST(PlaceCounts, TheTriangleAndItsIntegralAgree) {
  EXPECT_EQ(triangle(0.0), 1.0);
  EXPECT_EQ(triangle(-0.25), 0.75);
  EXPECT_EQ(triangle(1.5F), 0.0F);
  EXPECT_EQ(triangle_below(-2.0), 0.0);
  EXPECT_EQ(triangle_below(0.0), 0.5);
  EXPECT_EQ(triangle_below(0.5), 0.875);
  EXPECT_EQ(triangle_below(3.0), 1.0);
}

// The mean of its squares over its mean, 2/3, for either axis.
TEST(PlaceCounts, TheScaleMakesVarianceAndMeanEqual) {
  double sum = 0.0, squares = 0.0;
  for (int k = -500; k < 500; ++k) {
    const double height = triangle((k + 0.5) / 500.0);
    sum += height;
    squares += height * height;
  }
  EXPECT_NEAR(kKernelScale * squares * squares / (sum * sum), 1.0, 1e-5);
}

TEST(PlaceCounts, TheDenserOfEitherKindIsTaken) {
  const TwoExcesses one{{0.5, 5.0}, {0.5, 2.0}}, other{{0.5, 3.0}, {0.5, 9.0}};
  EXPECT_EQ(densest(one, other).all.rate, 5.0);
  EXPECT_EQ(densest(one, other).free.rate, 9.0);
}

}  // namespace
}  // namespace lookout::csht
