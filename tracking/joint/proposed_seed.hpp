#pragma once

#include "core/motion_element.hpp"
#include "csht/joint/pair_seeds.hpp"

namespace lookout::tracking {

/// A birth proposed from outside as a seed of the joint tracker, which computes the evidence for it as for
/// its own: the proposal's state, spread and age.
csht::BirthSeed seed_of(const core::MotionElement& element, const csht::ScanHistory& scans);

}  // namespace lookout::tracking
