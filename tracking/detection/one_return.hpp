#pragma once

#include <vector>

#include "tracking/detection/detection_window.hpp"
#include "tracking/detection/image_plane.hpp"

namespace lookout::tracking {

/// Leaves one peak of each echo: of peaks without a valley between them the strongest, and none that a
/// stronger echo at the same range explains as its sidelobe.
/// @param plane that the peaks are of. @param extent of an echo in it.
/// @param peaks sorted in place, the strongest first. Work: a line of cells for each pair at most, broken off
/// at the first valley.
void leave_one_peak_an_echo(const ImagePlane& plane, const EchoExtent& extent, const EchoParams& params,
                            std::vector<PlanePeak>& peaks);

}  // namespace lookout::tracking
