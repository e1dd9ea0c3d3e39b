#pragma once

#include <vector>

#include "tracking/association/assignment.hpp"

namespace lookout::tracking {

/// An assignment of all rows to columns.
struct RankedAssignment {
  std::vector<int> column_of_row;  ///< One column a row, none twice.
  double cost = 0.0;               ///< Sum of the entries.
};

/// The k cheapest assignments of rows to columns in their order: the set of all but those found is split by
/// forcing and forbidding entries, and the best of each part is an assignment problem of its own. [Murty1968]
class KBestAssignments {
 public:
  static constexpr double kForbidden = 1e9;  ///< Entries of this cost or more are never used.

  /// Which assignments are wanted.
  struct Wanted {
    int most = 1;                 ///< No more than so many, >= 1.
    double largest_excess = 1e6;  ///< None that costs so much more than the best, >= 0.
  };

  /// @param cost rows <= columns; finite. @return the cheapest first; empty where every assignment uses a
  /// forbidden entry; valid until the next call.
  const std::vector<RankedAssignment>& solve(const Eigen::MatrixXd& cost, const Wanted& wanted);

 private:
  /// The assignments that hold the first `fixed` rows as `best` has them and do not use the forbidden columns
  /// in the row after.
  struct Part {
    RankedAssignment best;
    int fixed = 0;
    std::vector<int> forbidden;
  };

  void split(const Eigen::MatrixXd& cost, const Part& part);
  void add_best_of(const Eigen::MatrixXd& cost, Part part);
  Part take_cheapest();

  AssignmentSolver solver_;
  std::vector<Part> parts_;
  std::vector<RankedAssignment> found_;
  Eigen::MatrixXd cost_;
};

}  // namespace lookout::tracking
