#pragma once

#include <vector>

#include "tracking/detection/image_plane.hpp"

namespace lookout::tracking {

/// Cells [first, last) of a plane each way.
struct CellBox {
  int first_beam = 0, last_beam = 0;  ///< Beams.
  int first_bin = 0, last_bin = 0;    ///< Bins.
};

/// A sum and of how many cells.
struct CellSum {
  double sum = 0.0;    ///< Of the values.
  double cells = 0.0;  ///< How many.

  /// Without another's cells, which are among them.
  CellSum operator-(const CellSum& other) const { return {sum - other.sum, cells - other.cells}; }
  /// With another's cells, none of which are among them.
  CellSum operator+(const CellSum& other) const { return {sum + other.sum, cells + other.cells}; }
  double mean() const { return cells > 0.0 ? sum / cells : 0.0; }  ///< 0 of no cell.
};

/// Sums over any box of a plane in four look-ups. [Crow1984]
class SummedArea {
 public:
  /// Two additions a cell; keeps no reference.
  void prepare(const ImagePlane& plane);
  /// Of the part of the box that lies in the plane.
  CellSum over(const CellBox& box) const;

 private:
  double at(int beam, int bin) const {
    return sums_[static_cast<std::size_t>(beam) * (static_cast<std::size_t>(num_bins_) + 1) +
                 static_cast<std::size_t>(bin)];
  }

  int num_beams_ = 0, num_bins_ = 0;
  std::vector<double> sums_;  ///< Of all cells before a beam and a bin.
};

}  // namespace lookout::tracking
