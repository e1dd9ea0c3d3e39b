#include "tracking/metrics/power_assignment.hpp"

#include <algorithm>
#include <cmath>

namespace lookout::tracking {
namespace {

/// Up to this order the powers of all distances of a scene stand side by side in a double; above it only
/// those near the largest of the pairs count, and they are scaled by it.
constexpr double kPlainOrder = 4.0;
constexpr Eigen::Index kFree = -1;

}  // namespace

double power_norm(std::span<const double> values, double order) {
  const double largest = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  if (!(largest > 0.0) || std::isinf(order)) return largest;
  double sum = 0.0;
  for (const double value : values) sum += std::pow(value / largest, order);
  return largest * std::pow(sum, 1.0 / order);
}

const std::vector<int>& PowerAssignment::solve(const Eigen::MatrixXd& distance, double order) {
  fill_costs(distance, order);
  const std::vector<int>& column_of_row = solver_.solve(cost_);
  paired_.clear();
  for (std::size_t row = 0; row < column_of_row.size(); ++row)
    if (column_of_row[row] >= 0)
      paired_.push_back(distance(static_cast<Eigen::Index>(row), column_of_row[row]));
  return column_of_row;
}

void PowerAssignment::fill_costs(const Eigen::MatrixXd& distance, double order) {
  if (order <= kPlainOrder) {
    const double scale = distance.maxCoeff() > 0.0 ? distance.maxCoeff() : 1.0;
    cost_ = distance.unaryExpr([&](double d) { return std::pow(d / scale, order); });
    return;
  }
  // The best sum is at most that of the bottleneck's own pairs, n times its power: no pair beyond `reach` is
  // in it.
  const auto pairs = static_cast<double>(std::min(distance.rows(), distance.cols()));
  const double least = bottleneck(distance);
  const double reach = least * std::pow(pairs, 1.0 / order);
  const double beyond = 2.0 * pairs + 1.0;
  const double power = std::isinf(order) ? 1.0 : order;
  cost_ = distance.unaryExpr([&](double d) {
    if (d > reach) return beyond;
    return least > 0.0 ? std::pow(d / least, power) : 0.0;
  });
}

double PowerAssignment::bottleneck(const Eigen::MatrixXd& distance) {
  sorted_.assign(distance.data(), distance.data() + distance.size());
  std::sort(sorted_.begin(), sorted_.end());
  sorted_.erase(std::unique(sorted_.begin(), sorted_.end()), sorted_.end());
  return *std::partition_point(sorted_.begin(), sorted_.end(),
                               [&](double limit) { return !pairs_within(distance, limit); });
}

/// Whether all of the smaller side can be paired at no more than `limit`: a maximum matching by augmenting
/// paths.
bool PowerAssignment::pairs_within(const Eigen::MatrixXd& distance, double limit) {
  partner_.assign(static_cast<std::size_t>(std::max(distance.rows(), distance.cols())), kFree);
  const Eigen::Index smaller = std::min(distance.rows(), distance.cols());
  for (Eigen::Index one = 0; one < smaller; ++one) {
    visited_.assign(partner_.size(), 0);
    if (!find_partner(distance, limit, one)) return false;
  }
  return true;
}

bool PowerAssignment::find_partner(const Eigen::MatrixXd& distance, double limit, Eigen::Index one) {
  const bool transposed = distance.rows() > distance.cols();
  for (std::size_t other = 0; other < partner_.size(); ++other) {
    const auto index = static_cast<Eigen::Index>(other);
    const double d = transposed ? distance(index, one) : distance(one, index);
    if (visited_[other] != 0 || d > limit) continue;
    visited_[other] = 1;
    if (partner_[other] != kFree && !find_partner(distance, limit, partner_[other])) continue;
    partner_[other] = one;
    return true;
  }
  return false;
}

}  // namespace lookout::tracking
