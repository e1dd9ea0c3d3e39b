#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "tracking/association/assignment.hpp"

namespace lookout::tracking {

/// (sum of values^order)^(1/order) of values >= 0, without overflow or underflow; their maximum for an
/// infinite order, 0 for none.
double power_norm(std::span<const double> values, double order);

/// Pairs the rows of a matrix of distances with its columns, all of the smaller side, so that the sum of the
/// pairs' distances to the power `order` is least; for an infinite order the largest of them is least (and
/// their sum among those). Right for any order: a plain power of 300 is 0 or infinite for most distances.
/// Keeps its buffers.
class PowerAssignment {
 public:
  /// @param distance finite and >= 0; @param order >= 1 or infinite.
  /// @return for each row its column, or -1; valid until the next call.
  const std::vector<int>& solve(const Eigen::MatrixXd& distance, double order);

  /// The distances of the pairs of the last `solve`.
  const std::vector<double>& paired() const { return paired_; }

 private:
  void fill_costs(const Eigen::MatrixXd& distance, double order);
  double bottleneck(const Eigen::MatrixXd& distance);
  bool pairs_within(const Eigen::MatrixXd& distance, double limit);
  bool find_partner(const Eigen::MatrixXd& distance, double limit, Eigen::Index one);

  AssignmentSolver solver_;
  Eigen::MatrixXd cost_;
  std::vector<double> sorted_, paired_;
  std::vector<Eigen::Index> partner_;
  std::vector<char> visited_;
};

}  // namespace lookout::tracking
