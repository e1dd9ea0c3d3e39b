#include "tracking/association/assignment.hpp"

#include <limits>

namespace lookout::tracking {

// Rows and columns are numbered from 1 inside, column 0 being the root of the alternating tree.
const std::vector<int>& AssignmentSolver::solve(const CostMatrix& cost) {
  const bool transposed = cost.rows() > cost.cols();
  const int n = static_cast<int>(transposed ? cost.cols() : cost.rows());
  const int m = static_cast<int>(transposed ? cost.rows() : cost.cols());
  const auto size_n = static_cast<std::size_t>(n) + 1;
  const auto size_m = static_cast<std::size_t>(m) + 1;
  row_potential_.assign(size_n, 0.0);
  column_potential_.assign(size_m, 0.0);
  row_of_column_.assign(size_m, 0);
  previous_column_.assign(size_m, 0);
  for (int row = 1; row <= n; ++row) augment(cost, transposed, row, m);

  column_of_row_.assign(static_cast<std::size_t>(cost.rows()), -1);
  for (int column = 1; column <= m; ++column) {
    const int row = row_of_column_[static_cast<std::size_t>(column)];
    if (row == 0) continue;
    const auto owner = static_cast<std::size_t>((transposed ? column : row) - 1);
    column_of_row_[owner] = (transposed ? row : column) - 1;
  }
  return column_of_row_;
}

void AssignmentSolver::augment(const CostMatrix& cost, bool transposed, int row, int num_columns) {
  const auto size = static_cast<std::size_t>(num_columns) + 1;
  distance_.assign(size, std::numeric_limits<double>::infinity());
  visited_.assign(size, 0);
  row_of_column_[0] = row;
  std::size_t column = 0;
  do {
    visited_[column] = 1;
    const std::size_t next = relax(cost, transposed, column, size);
    move_potentials(distance_[next], size);
    column = next;
  } while (row_of_column_[column] != 0);
  while (column != 0) {
    const auto previous = static_cast<std::size_t>(previous_column_[column]);
    row_of_column_[column] = row_of_column_[previous];
    column = previous;
  }
}

// Distances from the tree by way of `column`'s row; the nearest column outside it.
std::size_t AssignmentSolver::relax(const CostMatrix& cost, bool transposed, std::size_t column,
                                    std::size_t size) {
  const int row = row_of_column_[column];
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t next = 0;
  for (std::size_t j = 1; j < size; ++j) {
    if (visited_[j]) continue;
    const auto c = static_cast<Eigen::Index>(j) - 1;
    const double entry = transposed ? cost(c, row - 1) : cost(row - 1, c);
    const double reduced = entry - row_potential_[static_cast<std::size_t>(row)] - column_potential_[j];
    if (reduced < distance_[j]) {
      distance_[j] = reduced;
      previous_column_[j] = static_cast<int>(column);
    }
    if (distance_[j] < nearest) {
      nearest = distance_[j];
      next = j;
    }
  }
  return next;
}

// Keeps reduced costs non-negative, and zero within the tree, when the tree grows by a column `step` away.
void AssignmentSolver::move_potentials(double step, std::size_t size) {
  for (std::size_t j = 0; j < size; ++j) {
    if (visited_[j]) {
      row_potential_[static_cast<std::size_t>(row_of_column_[j])] += step;
      column_potential_[j] -= step;
    } else {
      distance_[j] -= step;
    }
  }
}

}  // namespace lookout::tracking
