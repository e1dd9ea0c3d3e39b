#pragma once

#include "core/sonar_params.hpp"
#include "core/sonar_scan.hpp"
#include "tracking/initiation/birth_method.hpp"
#include "tracking/management/track_book.hpp"

namespace lookout::tracking {

/// Begins a track on each proposal of `births` that the sonar sees at the scan's time.
/// @param book at the scan's time, its tracks updated with the scan.
void begin_on_proposals(BirthMethod& births, const core::PosedScan& scan, const core::SonarParams& sonar,
                        TrackBook& book);

}  // namespace lookout::tracking
