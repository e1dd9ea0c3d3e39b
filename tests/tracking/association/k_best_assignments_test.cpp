#include "tracking/association/k_best_assignments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/random.hpp"

namespace lookout::tracking {
namespace {

constexpr int kAll = 1000000;

/// Oracle: the costs of all assignments without a forbidden entry, cheapest first.
std::vector<double> all_costs(const Eigen::MatrixXd& cost, int row, std::vector<char>& used) {
  if (row == cost.rows()) return {0.0};
  std::vector<double> sums;
  for (int column = 0; column < cost.cols(); ++column) {
    char& is_used = used[static_cast<std::size_t>(column)];
    if (is_used || cost(row, column) >= KBestAssignments::kForbidden) continue;
    is_used = 1;
    for (const double rest : all_costs(cost, row + 1, used)) sums.push_back(cost(row, column) + rest);
    is_used = 0;
  }
  std::sort(sums.begin(), sums.end());
  return sums;
}

std::vector<double> all_costs(const Eigen::MatrixXd& cost) {
  std::vector<char> used(static_cast<std::size_t>(cost.cols()), 0);
  return all_costs(cost, 0, used);
}

Eigen::MatrixXd random_costs(int rows, int columns, core::Random& random) {
  Eigen::MatrixXd cost(rows, columns);
  for (Eigen::Index i = 0; i < cost.size(); ++i)
    cost(i) = random.bernoulli(0.2) ? KBestAssignments::kForbidden : random.uniform(-5.0, 5.0);
  return cost;
}

TEST(KBestAssignments, TwoByTwoByHand) {
  Eigen::MatrixXd cost(2, 2);
  cost << 1, 2, 2, 9;
  KBestAssignments assignments;
  const auto& found = assignments.solve(cost, {kAll, 100.0});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].column_of_row, (std::vector<int>{1, 0}));
  EXPECT_DOUBLE_EQ(found[0].cost, 4.0);
  EXPECT_DOUBLE_EQ(found[1].cost, 10.0);
}

TEST(KBestAssignments, EqualsEnumeration) {
  core::Random random(3);
  KBestAssignments assignments;
  for (int trial = 0; trial < 100; ++trial) {
    const int rows = 1 + random.index(4);
    const Eigen::MatrixXd cost = random_costs(rows, rows + random.index(3), random);
    const auto oracle = all_costs(cost);
    const auto& found = assignments.solve(cost, {kAll, 1e6});
    ASSERT_EQ(found.size(), oracle.size());
    std::set<std::vector<int>> different;
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k].cost, oracle[k], 1e-9);
      different.insert(found[k].column_of_row);
    }
    EXPECT_EQ(different.size(), found.size());
  }
}

TEST(KBestAssignments, StopsAtWhatIsWanted) {
  core::Random random(4);
  Eigen::MatrixXd cost(4, 6);
  for (Eigen::Index i = 0; i < cost.size(); ++i) cost(i) = random.uniform(0.0, 1.0);
  KBestAssignments assignments;
  EXPECT_EQ(assignments.solve(cost, {7, 1e6}).size(), 7U);
  const auto oracle = all_costs(cost);
  const auto within =
      std::count_if(oracle.begin(), oracle.end(), [&](double sum) { return sum <= oracle.front() + 0.5; });
  EXPECT_EQ(assignments.solve(cost, {kAll, 0.5}).size(), static_cast<std::size_t>(within));
}

TEST(KBestAssignments, NothingIsPossible) {
  const Eigen::MatrixXd cost = Eigen::MatrixXd::Constant(2, 3, KBestAssignments::kForbidden);
  KBestAssignments assignments;
  EXPECT_TRUE(assignments.solve(cost, {}).empty());
}

TEST(KBestAssignments, NoRowsHaveOneAssignment) {
  KBestAssignments assignments;
  const auto& found = assignments.solve(Eigen::MatrixXd(0, 3), {5, 1e6});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_DOUBLE_EQ(found[0].cost, 0.0);
}

}  // namespace
}  // namespace lookout::tracking
