#include "csht/fuzzy_partition.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace lookout::csht {
namespace {

WeightedPoints points_of(const std::vector<std::pair<FeaturePoint, float>>& list) {
  WeightedPoints points;
  for (const auto& [point, weight] : list) points.push_back(point, weight);
  points.pad();
  return points;
}

// Centres at 0 and 4, a point at 1: 1/d^2 is 1 and 1/9, so with m = 2 it belongs to them by .9 and .1. Eq.
// (22). The centre's weighted mean of Eq. (23) over the points 0 and 1 is then .81 / (1 + .81).
TEST(FuzzyPartition, MovesCentresByThePowerOfTheMembership) {
  const auto points = points_of({{{0, 0}, 1.0F}, {{1, 0}, 1.0F}, {{4, 0}, 1.0F}});
  FuzzyPartition partition(2.0);
  std::vector<FeaturePoint> centres{{0, 0}, {4, 0}};
  partition.update(points, centres);
  EXPECT_NEAR(centres[0].x, 0.81 / 1.81, 1e-4);
  EXPECT_NEAR(centres[1].x, (4.0 + 0.01) / 1.01, 1e-4);
}

TEST(FuzzyPartition, APointOnACentreBelongsToItAlone) {
  const auto points = points_of({{{0, 0}, 1.0F}, {{4, 0}, 1.0F}});
  FuzzyPartition partition(2.0);
  std::vector<FeaturePoint> centres{{0, 0}, {4, 0}};
  EXPECT_LT(partition.update(points, centres), 1e-4F);
  const auto statistics = partition.statistics(points, centres, 0.5);
  EXPECT_NEAR(statistics[0].membership, 1.0, 1e-5);
  EXPECT_NEAR(statistics[1].core_count, 1.0, 1e-5);
}

// [Yan2018] Eq. (18)-(20): a cell with three votes is three equal sampling points.
TEST(FuzzyPartition, AWeightIsThatManyPoints) {
  const auto weighted = points_of({{{0, 1}, 3.0F}, {{2, 0}, 1.0F}, {{9, 3}, 2.0F}});
  const auto repeated = points_of(
      {{{0, 1}, 1.0F}, {{0, 1}, 1.0F}, {{0, 1}, 1.0F}, {{2, 0}, 1.0F}, {{9, 3}, 1.0F}, {{9, 3}, 1.0F}});
  for (const double fuzzifier : {2.0, 2.5}) {
    FuzzyPartition partition(fuzzifier);
    std::vector<FeaturePoint> a{{1, 1}, {8, 2}}, b = a;
    partition.update(weighted, a);
    partition.update(repeated, b);
    EXPECT_NEAR(a[0].x, b[0].x, 1e-5);
    EXPECT_NEAR(a[1].y, b[1].y, 1e-5);
  }
}

// One centre: all memberships are 1, so S of Eq. (27) is the deviation of the points with N - 1.
TEST(FuzzyPartition, DeviationIsThatOfThePoints) {
  const auto points = points_of({{{-1, 0}, 2.0F}, {{1, 0}, 2.0F}});
  FuzzyPartition partition(2.0);
  const std::vector<FeaturePoint> centres{{0, 0}};
  const auto statistics = partition.statistics(points, centres, 0.5);
  EXPECT_NEAR(statistics[0].deviation[0], std::sqrt(4.0 / 3.0), 1e-5);
  EXPECT_NEAR(statistics[0].deviation[1], 0.0, 1e-5);
  EXPECT_NEAR(statistics[0].aggregation(), 1.0, 1e-5);
}

TEST(FuzzyPartition, RefusesAFuzzifierOfOne) {
  EXPECT_THROW(FuzzyPartition(1.0), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::csht
