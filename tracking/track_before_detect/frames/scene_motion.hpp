#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace lookout::tracking {

/// By how much the scene has moved from one grey frame to a later one (columns * rows values each) [px]: the
/// whole pixels of least median difference, then robust least squares on the gradients [Lucas1981].
Eigen::Vector2d scene_shift(std::span<const double> earlier, std::span<const double> later, int columns,
                            int rows);

/// What of the later frame is brighter than the earlier one moved onto it, over how much the two differ
/// nearby: targets that move against the scene stand out, also where the camera turns. 0 along the border.
std::vector<double> scene_residual(std::span<const double> earlier, std::span<const double> later,
                                   int columns, int rows);

}  // namespace lookout::tracking
