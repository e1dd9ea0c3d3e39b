#include "csht/likelihood/clutter/point_bins.hpp"

namespace lookout::csht {

void PointBins::reserve(std::size_t points) {
  start_.reserve(kMostBins + 2);
  sorted_.reserve(points);
}

void PointBins::build(const std::vector<BinnedPoint>& points, double side) {
  sorted_.clear();
  if (points.empty()) return;
  choose_grid(points, side);
  const auto bin_of = [this](const BinnedPoint& p) {
    return static_cast<std::size_t>(row(static_cast<double>(p.y))) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column(static_cast<double>(p.x)));
  };
  start_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 2, 0);
  for (const BinnedPoint& point : points) ++start_[bin_of(point) + 2];
  for (std::size_t k = 2; k < start_.size(); ++k) start_[k] += start_[k - 1];
  sorted_.resize(points.size());
  for (const BinnedPoint& point : points)
    sorted_[static_cast<std::size_t>(start_[bin_of(point) + 1]++)] = point;
}

void PointBins::choose_grid(const std::vector<BinnedPoint>& points, double side) {
  const auto [left, right] = std::minmax_element(
      points.begin(), points.end(), [](const BinnedPoint& a, const BinnedPoint& b) { return a.x < b.x; });
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](const BinnedPoint& a, const BinnedPoint& b) { return a.y < b.y; });
  low_x_ = static_cast<double>(left->x);
  low_y_ = static_cast<double>(low->y);
  const double width = static_cast<double>(right->x) - low_x_, height = static_cast<double>(high->y) - low_y_;
  const auto bins = [&](double s) { return (std::floor(width / s) + 1.0) * (std::floor(height / s) + 1.0); };
  while (bins(side) > kMostBins) side *= 2.0;
  inverse_side_ = 1.0 / side;
  columns_ = static_cast<int>(width / side) + 1;
  rows_ = static_cast<int>(height / side) + 1;
}

}  // namespace lookout::csht
