#pragma once

#include "core/motion_element.hpp"
#include "csht/candidate.hpp"
#include "csht/hough_window.hpp"

namespace lookout::csht {

/// A candidate with its state at `epoch` [s] as a motion element at the newest scan. [Yan2018] Eq. (40).
core::MotionElement to_element(const Candidate& candidate, const HoughWindow& window, double epoch);

}  // namespace lookout::csht
