#pragma once

#include <vector>

#include "tracking/detection/detection_window.hpp"
#include "tracking/detection/image_plane.hpp"

namespace lookout::tracking {

/// Overwrites `peaks` with the cells that are the greatest within `reach` about them, in the order of the
/// plane; of equals the first one. Work: two comparisons a cell for most cells.
void find_peaks(const ImagePlane& plane, const CellReach& reach, std::vector<PlanePeak>& peaks);

}  // namespace lookout::tracking
