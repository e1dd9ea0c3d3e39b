#include "tracking/association/k_best_assignments.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace lookout::tracking {

const std::vector<RankedAssignment>& KBestAssignments::solve(const Eigen::MatrixXd& cost,
                                                             const Wanted& wanted) {
  assert(cost.rows() <= cost.cols());
  found_.clear();
  parts_.clear();
  add_best_of(cost, {});
  while (!parts_.empty()) {
    const Part part = take_cheapest();
    if (!found_.empty() && part.best.cost > found_.front().cost + wanted.largest_excess) break;
    found_.push_back(part.best);
    if (static_cast<int>(found_.size()) >= wanted.most) break;
    split(cost, part);
  }
  return found_;
}

// Each part of the rest agrees with the best up to a row and differs there.
void KBestAssignments::split(const Eigen::MatrixXd& cost, const Part& part) {
  for (int row = part.fixed; row < cost.rows(); ++row) {
    Part rest{part.best, row, row == part.fixed ? part.forbidden : std::vector<int>{}};
    rest.forbidden.push_back(part.best.column_of_row[static_cast<std::size_t>(row)]);
    add_best_of(cost, std::move(rest));
  }
}

void KBestAssignments::add_best_of(const Eigen::MatrixXd& cost, Part part) {
  cost_ = cost;
  for (int row = 0; row < part.fixed; ++row) {
    const int column = part.best.column_of_row[static_cast<std::size_t>(row)];
    cost_.row(row).setConstant(kForbidden);
    cost_(row, column) = cost(row, column);
  }
  for (const int column : part.forbidden) cost_(part.fixed, column) = kForbidden;
  part.best.column_of_row = solver_.solve(cost_);
  part.best.cost = 0.0;
  for (int row = 0; row < cost.rows(); ++row) {
    const double entry = cost_(row, part.best.column_of_row[static_cast<std::size_t>(row)]);
    if (entry >= kForbidden) return;
    part.best.cost += entry;
  }
  parts_.push_back(std::move(part));
}

KBestAssignments::Part KBestAssignments::take_cheapest() {
  const auto cheapest = std::min_element(
      parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.best.cost < b.best.cost; });
  Part part = std::move(*cheapest);
  *cheapest = std::move(parts_.back());
  parts_.pop_back();
  return part;
}

}  // namespace lookout::tracking
