#pragma once

#include <vector>

#include "tracking/detection/detection_window.hpp"
#include "tracking/detection/image_plane.hpp"

namespace lookout::tracking {

/// Smooths a plane over the extent of an echo: a triangle each way, as a running mean applied twice. What is
/// gained over the single cell is what several looks at the same echo are worth.
class EchoFilter {
 public:
  /// Replaces the plane's values by their means about each cell; at the border, over the cells that there
  /// are. @param widths of the running means [cells], >= 1; 1 leaves that direction as it is. Work: four
  /// operations a cell and direction, whatever the width.
  void apply(const CellReach& widths, ImagePlane& plane);

 private:
  void along_range(int width, ImagePlane& plane);
  void over_beams(int width, ImagePlane& plane);

  std::vector<double> sums_;     ///< Running sums along a beam.
  std::vector<double> columns_;  ///< Sums over the beams at hand, by bin.
  ImagePlane copy_;
};

}  // namespace lookout::tracking
