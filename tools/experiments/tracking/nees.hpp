#pragma once

#include <span>

#include "core/ground_truth.hpp"
#include "core/motion_element.hpp"

namespace lookout::tools {

/// Normalised estimation error squared over its 4 degrees, the mean over the elements, each against the
/// target nearest to it: 1 where covariances say what errors are, below it where they are too wide
/// [BarShalom2001] 5.4. Meant for windows with the right count.
/// @throws std::invalid_argument without elements or targets.
double mean_nees(const core::GroundTruth& truth, std::span<const core::MotionElement> elements);

}  // namespace lookout::tools
