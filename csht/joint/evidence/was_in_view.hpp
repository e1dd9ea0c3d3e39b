#pragma once

#include "csht/joint/density/trajectory_cloud.hpp"
#include "csht/likelihood/scan_history.hpp"

namespace lookout::csht {

/// Of range and half sector, that a target which was seen at their edge may be estimated beyond it.
inline constexpr double kBeyondEdge = 1.1;

/// Whether any scan from the newest to that of age `oldest` had the mean of a density in view, of whichever
/// sonar. Where none had, no scan speaks for or against a target: trajectories there are those of targets
/// that were never heard, there is no end to them, and their evidence is only the room that a proposal takes
/// up.
bool was_in_view(const CloudMoments& moments, const ScanHistory& scans, int oldest);

}  // namespace lookout::csht
