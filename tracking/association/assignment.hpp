#pragma once

#include <Eigen/Core>
#include <vector>

namespace lookout::tracking {

/// Minimum-cost assignment of rows to columns of a real-valued rectangular matrix, by shortest augmenting
/// paths (Kuhn 1955; Jonker and Volgenant 1987). O(n^2 m) for n = min(rows, columns), m = max. Keeps its
/// buffers, so that repeated use allocates nothing once warm.
class AssignmentSolver {
 public:
  /// A matrix or a block of a larger one, so that a caller can keep its storage.
  using CostMatrix = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

  /// Every row (where rows <= columns; else every column) is assigned. Costs must be finite.
  /// @return for each row its column, or -1; valid until the next call.
  const std::vector<int>& solve(const CostMatrix& cost);

 private:
  void augment(const CostMatrix& cost, bool transposed, int row, int num_columns);
  std::size_t relax(const CostMatrix& cost, bool transposed, std::size_t column, std::size_t size);
  void move_potentials(double step, std::size_t size);

  std::vector<double> row_potential_, column_potential_, distance_;
  std::vector<int> row_of_column_, previous_column_, column_of_row_;
  std::vector<char> visited_;
};

}  // namespace lookout::tracking
