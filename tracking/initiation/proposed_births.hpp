#pragma once

#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "tracking/initiation/birth_method.hpp"
#include "tracking/management/trajectory_book.hpp"

namespace lookout::tracking {

/// Begins a trajectory on each proposal of `births` that the sonar sees at the scan's time.
/// @param book at the scan's time, its trajectories updated with the scan.
void begin_on_proposals(BirthMethod& births, const core::PosedScan& scan, const core::SonarParams& sonar,
                        TrajectoryBook& book);

}  // namespace lookout::tracking
