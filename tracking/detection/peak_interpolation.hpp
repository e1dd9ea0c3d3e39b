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

/// Top of the parabola through three equally spaced values, the middle one being the highest.
struct ParabolaTop {
  double place = 0.0;   ///< From the middle, in steps, in [-0.5, 0.5]; 0 where the three do not bend down.
  double height = 0.0;  ///< Above the middle value.
};
ParabolaTop parabola_top(double before, double middle, double behind);  ///< See ParabolaTop.

/// The top of a parabola through the logarithms of the cell's value and of those `reach` to either side, each
/// way for itself: exact for a Gaussian echo. No farther off than half the reach; a
/// direction in which the plane ends keeps its cell.
/// @param reach >= 1 each way.
PeakPlace interpolate(const ImagePlane& plane, const PlanePeak& peak, const CellReach& reach);

}  // namespace lookout::tracking
