#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace lookout::csht {

/// A weighted point in a plane, and the scan that it came from.
struct BinnedPoint {
  float x = 0.0F, y = 0.0F;  ///< In units of the caller's.
  float weight = 1.0F;       ///< Factor on its count, >= 0.
  int look = 0;              ///< Number of its scan.
  float free = 1.0F;         ///< Share of it that nothing else is known to explain, in [0, 1].
};

/// Points sorted into square bins, so that those near a place are found without looking at the rest.
class PointBins {
 public:
  /// Sorts `points` into bins of side `side` (> 0), or wider where that would take more than `kMostBins`. Its
  /// buffers are reused. Cost: O(points + bins).
  void build(const std::vector<BinnedPoint>& points, double side);

  void reserve(std::size_t points);  ///< Builds of no more allocate nothing.

  /// Calls `take(point)` for all points of the bins that the box about (x, y) meets, in an order that depends
  /// on the points alone; some lie outside the box.
  template <class Take>
  void visit(double x, double y, double half_x, double half_y, const Take& take) const {
    if (sorted_.empty()) return;
    const int last_x = column(x + half_x), last_y = row(y + half_y);
    for (int j = row(y - half_y); j <= last_y; ++j) {
      const auto line = static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_);
      const std::size_t first = line + static_cast<std::size_t>(column(x - half_x));
      const auto begin = static_cast<std::size_t>(start_[first]);
      const auto end = static_cast<std::size_t>(start_[line + static_cast<std::size_t>(last_x) + 1]);
      for (std::size_t k = begin; k < end; ++k) take(sorted_[k]);
    }
  }

  static constexpr int kMostBins = 1 << 15;  ///< More are not made.

 private:
  int column(double x) const { return bin(x - low_x_, columns_); }
  int row(double y) const { return bin(y - low_y_, rows_); }
  int bin(double offset, int count) const {
    return static_cast<int>(std::clamp(std::floor(offset * inverse_side_), 0.0, count - 1.0));
  }
  void choose_grid(const std::vector<BinnedPoint>& points, double side);

  double low_x_ = 0.0, low_y_ = 0.0, inverse_side_ = 1.0;
  int columns_ = 1, rows_ = 1;
  std::vector<int> start_;  ///< Bin k holds sorted_[start_[k]] up to sorted_[start_[k + 1]].
  std::vector<BinnedPoint> sorted_;
};

}  // namespace lookout::csht
