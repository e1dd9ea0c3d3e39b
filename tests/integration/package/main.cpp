// A program outside the tree that uses the installed package.
#include "core/random.hpp"
#include "tracking/association/assignment.hpp"

int main() {
  lookout::core::Random random(1);
  Eigen::MatrixXd cost(2, 2);
  cost << 1, 2, 2, 9;
  lookout::tracking::AssignmentSolver solver;
  return solver.solve(cost)[0] == 1 && random.uniform(0, 1) < 1 ? 0 : 1;
}
