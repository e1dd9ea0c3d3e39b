#pragma once

#include "tracking/detection/detection_window.hpp"
#include "tracking/detection/image_plane.hpp"

namespace lookout::tracking {

/// Where a peak lies between the cells.
struct PeakPlace {
  double beam = 0.0;  ///< In beams from the first beam's centre.
  double bin = 0.0;   ///< In bins from the first bin's centre.
  double gain = 1.0;  ///< Its value over that of its cell, >= 1.
};

/// The top of a parabola through the logarithms of the cell's value and of those `reach` to either side, each
/// way for itself: exact for a Gaussian echo. No farther off than half the reach; a
/// direction in which the plane ends keeps its cell.
/// @param reach >= 1 each way.
PeakPlace interpolate(const ImagePlane& plane, const PlanePeak& peak, const CellReach& reach);

}  // namespace lookout::tracking
