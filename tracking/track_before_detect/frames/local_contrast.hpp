#pragma once

#include <span>
#include <vector>

namespace lookout::tracking {

/// How much each pixel of a grey frame (columns * rows values) stands out from all eight directions around
/// it: the blurred level less the greatest of the means of eight neighbours, over the deviation of the ring
/// between; the greatest of three widths of a target, .6, 1.2 and 2.4 px. Edges, ridges, gradients and
/// stripes do not stand out, for one of the eight lies on them; and where the scene is rough, more is asked.
std::vector<double> local_contrast(std::span<const double> grey, int columns, int rows);

}  // namespace lookout::tracking
