#include "tracking/metrics/ospa.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

using Points = std::vector<Eigen::Vector2d>;

Points random_points(core::Random& random, int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.emplace_back(random.uniform(0.0, 60.0), random.uniform(0.0, 60.0));
  return points;
}

TEST(Ospa, TwoEmptySetsAreEqual) {
  EXPECT_EQ(Ospa()(Points{}, Points{}).total, 0.0);
}

TEST(Ospa, OneEmptySetCostsTheCutoffAllOfItCardinality) {
  const OspaResult result = Ospa()(Points{{1, 2}, {3, 4}}, Points{});
  EXPECT_DOUBLE_EQ(result.total, 20.0);
  EXPECT_DOUBLE_EQ(result.cardinality, 20.0);
  EXPECT_EQ(result.localization, 0.0);
}

// By hand: pairs at 3 and 4 m, one estimate too many: loc^2 = 25/3, card^2 = 400/3, total^2 = 425/3.
TEST(Ospa, PartsOfAPaperExample) {
  const OspaResult result = Ospa()(Points{{0, 0}, {100, 0}}, Points{{50, 50}, {100, 4}, {3, 0}});
  EXPECT_NEAR(result.localization, std::sqrt(25.0 / 3.0), 1e-12);
  EXPECT_NEAR(result.cardinality, std::sqrt(400.0 / 3.0), 1e-12);
  EXPECT_NEAR(result.total, std::sqrt(425.0 / 3.0), 1e-12);
  EXPECT_EQ(result.num_truth, 2);
  EXPECT_EQ(result.num_tracks, 3);
}

// Greedy would take the pair at 1 m and leave one at 9 m (sum of squares 82); the optimum is 4 and 4 (32).
TEST(Ospa, AssignmentIsOptimalNotGreedy) {
  const OspaResult result = Ospa()(Points{{0, 0}, {5, 0}}, Points{{4, 0}, {9, 0}});
  EXPECT_NEAR(result.total, std::sqrt(32.0 / 2.0), 1e-12);
}

TEST(Ospa, OrderOneIsTheMeanDistance) {
  const OspaResult result =
      Ospa({.cutoff = 10.0, .order = 1.0})(Points{{0, 0}, {30, 0}}, Points{{2, 0}, {90, 0}});
  EXPECT_NEAR(result.total, (2.0 + 10.0) / 2.0, 1e-12);
}

TEST(Ospa, IsSymmetricAndKeepsTheTriangleInequality) {
  core::Random random(7);
  Ospa ospa;
  for (int round = 0; round < 50; ++round) {
    const Points a = random_points(random, random.index(6));
    const Points b = random_points(random, random.index(6));
    const Points c = random_points(random, random.index(6));
    EXPECT_NEAR(ospa(a, b).total, ospa(b, a).total, 1e-9);
    EXPECT_LE(ospa(a, c).total, ospa(a, b).total + ospa(b, c).total + 1e-9);
    EXPECT_NEAR(ospa(a, a).total, 0.0, 1e-12);
  }
}

TEST(Ospa, HundredsOfTargetsShiftedByThreeMetresCostThree) {
  Points truth, estimate;
  for (int i = 0; i < 400; ++i) {
    truth.emplace_back(40.0 * (i % 20), 40.0 * (i / 20));
    estimate.insert(estimate.begin(), truth.back() + Eigen::Vector2d(3.0, 0.0));
  }
  EXPECT_NEAR(Ospa()(truth, estimate).total, 3.0, 1e-9);
}

// [Schuhmacher2008] Section III: for p = infinity the largest distance of the best pairs, the cut-off where
// the counts differ.
TEST(Ospa, AnInfiniteOrderIsTheWorstPairOfTheBestPairing) {
  Ospa ospa({.cutoff = 20.0, .order = std::numeric_limits<double>::infinity()});
  // Pairs 0-4 and 5-9 are 4 m apart each; 5-4 and 0-9 would leave 9 m.
  EXPECT_DOUBLE_EQ(ospa(Points{{0, 0}, {5, 0}}, Points{{4, 0}, {9, 0}}).total, 4.0);
  EXPECT_DOUBLE_EQ(ospa(Points{{0, 0}, {100, 0}}, Points{{10, 0}, {103, 0}}).total, 10.0);
  EXPECT_DOUBLE_EQ(ospa(Points{{0, 0}}, Points{{1, 0}, {50, 0}}).total, 20.0);
  EXPECT_DOUBLE_EQ(ospa(Points{{0, 0}}, Points{{1, 0}, {50, 0}}).localization, 1.0);
  EXPECT_EQ(ospa(Points{}, Points{}).total, 0.0);
}

// By hand, two pairs at 3 and 4 m, order p: ((3^p + 4^p) / 2)^(1/p) = 4 ((.75^p + 1) / 2)^(1/p).
TEST(Ospa, HighOrdersNeitherOverflowNorVanish) {
  for (const double order : {5.0, 30.0, 300.0, 1000.0, 1e6}) {
    const OspaResult result =
        Ospa({.cutoff = 1e6, .order = order})(Points{{0, 0}, {100, 0}}, Points{{3, 0}, {100, 4}});
    EXPECT_NEAR(result.total, 4.0 * std::pow((std::pow(0.75, order) + 1.0) / 2.0, 1.0 / order), 1e-9)
        << order;
  }
  // One too many of two: total^p = (1^p + 20^p) / 2, which is 20 (1/2)^(1/p) to many digits.
  EXPECT_NEAR(Ospa({.order = 350.0})(Points{{0, 0}}, Points{{1, 0}, {50, 0}}).total,
              20.0 * std::pow(0.5, 1.0 / 350.0), 1e-9);
}

// The distance of two sets grows with the order (a power mean) up to that of the infinite one.
TEST(Ospa, GrowsWithTheOrder) {
  core::Random random(11);
  for (int round = 0; round < 20; ++round) {
    const Points a = random_points(random, 6), b = random_points(random, 6);
    double before = 0.0;
    for (const double order : {1.0, 2.0, 4.0, 8.0, 64.0, 512.0, std::numeric_limits<double>::infinity()}) {
      const double total = Ospa({.order = order})(a, b).total;
      EXPECT_GE(total, before - 1e-9);
      before = total;
    }
  }
}

TEST(Ospa, RefusesBadParams) {
  EXPECT_THROW(Ospa({.cutoff = std::numeric_limits<double>::infinity()}), std::invalid_argument);
  EXPECT_THROW(Ospa({.cutoff = 0.0}), std::invalid_argument);
  EXPECT_THROW(Ospa({.order = 0.5}), std::invalid_argument);
}

}  // namespace
}  // namespace lookout::tracking
