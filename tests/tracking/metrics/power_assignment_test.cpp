#include "tracking/metrics/power_assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Eigen::MatrixXd random_distances(core::Random& random, int rows, int columns) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&random] { return random.uniform(0.0, 20.0); });
}

/// The least power norm over all ways to pair the rows with columns (rows <= columns), by trying each.
double least_norm(const Eigen::MatrixXd& distance, double order) {
  std::vector<int> columns(static_cast<std::size_t>(distance.cols()));
  std::iota(columns.begin(), columns.end(), 0);
  double least = kInfinity;
  do {
    std::vector<double> pairs;
    for (Eigen::Index row = 0; row < distance.rows(); ++row)
      pairs.push_back(distance(row, columns[static_cast<std::size_t>(row)]));
    least = std::min(least, power_norm(pairs, order));
  } while (std::next_permutation(columns.begin(), columns.end()));
  return least;
}

TEST(PowerAssignment, NormIsThatOfTheDefinition) {
  const std::vector<double> values{3.0, 4.0};
  EXPECT_DOUBLE_EQ(power_norm(values, 1.0), 7.0);
  EXPECT_DOUBLE_EQ(power_norm(values, 2.0), 5.0);
  EXPECT_DOUBLE_EQ(power_norm(values, kInfinity), 4.0);
  EXPECT_NEAR(power_norm(values, 1000.0), 4.0, 1e-12);
  EXPECT_EQ(power_norm({}, 2.0), 0.0);
}

TEST(PowerAssignment, IsTheBestOfAllPairingsAtAnyOrder) {
  core::Random random(5);
  PowerAssignment assignment;
  for (const double order : {1.0, 2.0, 4.0, 10.0, 100.0, 1000.0, kInfinity})
    for (int round = 0; round < 10; ++round) {
      const Eigen::MatrixXd distance = random_distances(random, 4, 6);
      assignment.solve(distance, order);
      EXPECT_NEAR(power_norm(assignment.paired(), order), least_norm(distance, order), 1e-9) << order;
      assignment.solve(distance.transpose(), order);
      EXPECT_NEAR(power_norm(assignment.paired(), order), least_norm(distance, order), 1e-9) << order;
    }
}

TEST(PowerAssignment, AllZerosArePairs) {
  PowerAssignment assignment;
  EXPECT_EQ(assignment.solve(Eigen::MatrixXd::Zero(2, 3), kInfinity).size(), 2u);
  EXPECT_EQ(assignment.paired(), (std::vector<double>{0.0, 0.0}));
}

}  // namespace
}  // namespace lookout::tracking
