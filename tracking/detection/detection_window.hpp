#pragma once

#include "tracking/detection/detection_params.hpp"

namespace lookout::tracking {

/// Half-power extent of a point's echo in the image; fractions count, at least one cell each way.
struct EchoExtent {
  double beams = 1.0;  ///< Width [beams], >= 1.
  double bins = 1.0;   ///< Length [bins], >= 1.
};

/// So many cells to either side.
struct CellReach {
  int beams = 0;  ///< Over beams, >= 0.
  int bins = 0;   ///< Along range, >= 0.
};

/// All that is counted in cells, from the extent of an echo.
struct DetectionWindow {
  CellReach smoothing{1, 1};   ///< Whole widths [cells], >= 1: the filter matched to an echo.
  CellReach peak{1, 1};        ///< A peak is the greatest within this reach.
  CellReach guard{2, 2};       ///< Cells within it may hold the echo's own power.
  CellReach reference{5, 10};  ///< Cells within it and beyond the guard tell the background.
};

/// The window for echoes of this extent. @param beams, bins of the image, which bound it.
DetectionWindow window_for(const EchoExtent& extent, const ReferenceParams& params, int beams, int bins);

}  // namespace lookout::tracking
