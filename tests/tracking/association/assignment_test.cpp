#include "tracking/association/assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

double cost_of(const Eigen::MatrixXd& cost, const std::vector<int>& columns) {
  double total = 0.0;
  for (Eigen::Index row = 0; row < cost.rows(); ++row) {
    const int column = columns[static_cast<std::size_t>(row)];
    if (column >= 0) total += cost(row, column);
  }
  return total;
}

/// Oracle: every permutation, for rows <= columns.
double cheapest_by_enumeration(const Eigen::MatrixXd& cost) {
  std::vector<int> columns(static_cast<std::size_t>(cost.cols()));
  std::iota(columns.begin(), columns.end(), 0);
  double best = std::numeric_limits<double>::infinity();
  do {
    best = std::min(best, cost_of(cost, columns));
  } while (std::next_permutation(columns.begin(), columns.end()));
  return best;
}

Eigen::MatrixXd random_costs(int rows, int columns, core::Random& random) {
  Eigen::MatrixXd cost(rows, columns);
  for (Eigen::Index i = 0; i < cost.size(); ++i) cost(i) = random.uniform(-5.0, 5.0);
  return cost;
}

TEST(Assignment, BeatsGreedy) {
  Eigen::MatrixXd cost(2, 2);
  cost << 1, 2, 2, 9;  // greedy takes 1 + 9, the optimum is 2 + 2
  AssignmentSolver solver;
  EXPECT_EQ(solver.solve(cost), (std::vector<int>{1, 0}));
}

TEST(Assignment, EqualsEnumerationOnRandomRectangles) {
  core::Random random(1);
  AssignmentSolver solver;
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::MatrixXd cost = random_costs(1 + random.index(5), 5 + random.index(2), random);
    EXPECT_NEAR(cost_of(cost, solver.solve(cost)), cheapest_by_enumeration(cost), 1e-9);
    const Eigen::MatrixXd tall = cost.transpose();
    EXPECT_NEAR(cost_of(tall, solver.solve(tall)), cheapest_by_enumeration(cost), 1e-9);
  }
}

TEST(Assignment, EmptyMatrices) {
  AssignmentSolver solver;
  EXPECT_TRUE(solver.solve(Eigen::MatrixXd(0, 3)).empty());
  EXPECT_EQ(solver.solve(Eigen::MatrixXd(2, 0)), (std::vector<int>{-1, -1}));
}

TEST(Assignment, HundredsOfRowsStayOneToOne) {
  core::Random random(2);
  AssignmentSolver solver;
  std::vector<int> columns = solver.solve(random_costs(300, 250, random));
  EXPECT_EQ(std::count(columns.begin(), columns.end(), -1), 50);
  std::sort(columns.begin(), columns.end());
  EXPECT_EQ(std::adjacent_find(columns.begin() + 50, columns.end()), columns.end());
}

}  // namespace
}  // namespace lookout::tracking
